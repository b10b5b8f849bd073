#include "carmen_log.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:CarmenLog", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::LogSource> {
                  return std::make_unique<opal::carmen_log::CarmenLog>(options.at("laser_message"));
                });
}

}  // namespace

OPAL_PLUGIN("carmen_log", "0.1.0", register_types)
