#include "ros2_bag.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::ros2_bag::Ros2Bag>({.name = "opal:Ros2Bag"}, opal::recording::topic_choice);
}

}  // namespace

OPAL_PLUGIN("ros2_bag", "0.1.0", register_types)
