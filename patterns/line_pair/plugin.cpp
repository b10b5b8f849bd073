#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:LinePair", /*consumes*/ {"opal:Wall"}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::PatternTemplate> {
                  return std::make_unique<LinePair>(options);
                });
}

}  // namespace

OPAL_PLUGIN("line_pair", "0.1.0", register_types)
