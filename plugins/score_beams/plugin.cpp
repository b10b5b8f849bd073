#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::score_beams::BeamScorer>({.name = "opal:Beams"});
}

}  // namespace

OPAL_PLUGIN("score_beams", "0.6.0", register_types)
