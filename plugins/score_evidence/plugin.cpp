#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::score_evidence::EvidenceScorer>({.name = "opal:Evidence"});
}

}  // namespace

OPAL_PLUGIN("score_evidence", "0.1.0", register_types)
