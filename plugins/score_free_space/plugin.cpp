#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::score_free_space::FreeSpaceScorer>({.name = "opal:FreeSpace"});
}

}  // namespace

OPAL_PLUGIN("score_free_space", "0.1.0", register_types)
