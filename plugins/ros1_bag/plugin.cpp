#include "ros1_bag.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:Ros1Bag", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::LogSource> {
                  return std::make_unique<opal::ros1_bag::Ros1Bag>(opal::recording::topic_choice(options));
                });
}

}  // namespace

OPAL_PLUGIN("ros1_bag", "0.1.0", register_types)
