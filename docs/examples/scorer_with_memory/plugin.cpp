#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"acme:NewObjects", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::HypothesisScorer> {
                  return std::make_unique<NewObjectsScorer>(options);
                });
}

}  // namespace

OPAL_PLUGIN("new_objects", "1.0.0", register_types)
