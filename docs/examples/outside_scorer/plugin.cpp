#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"acme:LikelihoodField", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::HypothesisScorer> {
                  return std::make_unique<LikelihoodFieldScorer>(options);
                });
}

}  // namespace

OPAL_PLUGIN("likelihood_field", "1.0.0", register_types)
