#include "scorer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) { registrar.add<NewObjectsScorer>({.name = "acme:NewObjects"}); }

}  // namespace

OPAL_PLUGIN("new_objects", "1.0.0", register_types)
