#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:WallSlide", /*consumes*/ {"opal:Wall"}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::PatternTemplate> {
                  return std::make_unique<WallSlide>(options);
                });
}

}  // namespace

OPAL_PLUGIN("wall_slide", "0.1.0", register_types)
