#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::score_lack_of_fit::LackOfFitScorer>({.name = "opal:LackOfFit"});
}

}  // namespace

OPAL_PLUGIN("score_lack_of_fit", "0.1.0", register_types)
