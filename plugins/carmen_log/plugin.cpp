#include "carmen_log.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add(opal::TypeInfo{"opal:CarmenLog", {}, {}}, opal::Factory<opal::LogSource>([](const nlohmann::json& options) {
                  return std::make_unique<carmen_log::CarmenLog>(options.at("laser_message").get<std::string>());
                }));
}

}  // namespace

OPAL_PLUGIN("carmen_log", "0.1.0", register_types)
