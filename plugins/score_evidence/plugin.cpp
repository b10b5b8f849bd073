#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:Evidence", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::HypothesisScorer> {
                  return std::make_unique<EvidenceScorer>(options);
                });
}

}  // namespace

OPAL_PLUGIN("score_evidence", "0.1.0", register_types)
