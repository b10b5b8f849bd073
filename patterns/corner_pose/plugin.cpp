#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:CornerPose", /*consumes*/ {"opal:Corner"}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::PatternTemplate> {
                  return std::make_unique<CornerPose>(options);
                });
}

}  // namespace

OPAL_PLUGIN("corner_pose", "0.1.0", register_types)
