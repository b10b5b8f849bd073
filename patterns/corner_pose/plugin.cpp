#include "template.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::corner_pose::CornerPose>({.name = "opal:CornerPose", .consumes = {"opal:Corner"}});
}

}  // namespace

OPAL_PLUGIN("corner_pose", "0.1.0", register_types)
