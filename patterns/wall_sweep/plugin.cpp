#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:WallSweep", /*consumes*/ {"opal:Wall"}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::PatternTemplate> {
                  return std::make_unique<WallSweep>(options);
                });
}

}  // namespace

OPAL_PLUGIN("wall_sweep", "0.1.0", register_types)
