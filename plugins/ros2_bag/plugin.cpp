#include "ros2_bag.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:Ros2Bag", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::LogSource> {
                  return std::make_unique<opal::ros2_bag::Ros2Bag>(opal::recording::topic_choice(options));
                });
}

}  // namespace

OPAL_PLUGIN("ros2_bag", "0.1.0", register_types)
