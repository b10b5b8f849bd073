#include "ros1_bag.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::ros1_bag::Ros1Bag>({.name = "opal:Ros1Bag"}, opal::recording::topic_choice);
}

}  // namespace

OPAL_PLUGIN("ros1_bag", "0.1.0", register_types)
