#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<LikelihoodFieldScorer>({.name = "acme:LikelihoodField"});
}

}  // namespace

OPAL_PLUGIN("likelihood_field", "1.0.0", register_types)
