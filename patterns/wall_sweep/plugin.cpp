#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::wall_sweep::WallSweep>({.name = "opal:WallSweep", .consumes = {"opal:Wall"}});
}

}  // namespace

OPAL_PLUGIN("wall_sweep", "0.1.0", register_types)
