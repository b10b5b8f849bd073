#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:CirclePair", /*consumes*/ {"opal:Column"}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::PatternTemplate> {
                  return std::make_unique<CirclePair>(options);
                });
}

}  // namespace

OPAL_PLUGIN("circle_pair", "0.1.0", register_types)
