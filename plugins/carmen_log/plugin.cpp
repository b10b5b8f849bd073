#include "carmen_log.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

std::string laser_messages(const nlohmann::json& options) { return options.at("laser_message"); }

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::carmen_log::CarmenLog>({.name = "opal:CarmenLog"}, laser_messages);
}

}  // namespace

OPAL_PLUGIN("carmen_log", "0.1.0", register_types)
