#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:Beams", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::HypothesisScorer> {
                  return std::make_unique<BeamScorer>(options);
                });
}

}  // namespace

OPAL_PLUGIN("score_beams", "0.6.0", register_types)
