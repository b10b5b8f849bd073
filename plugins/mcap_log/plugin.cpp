#include "mcap_log.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:McapLog", /*consumes*/ {}, /*produces*/ {}},
                [](const nlohmann::json& options) -> std::unique_ptr<opal::LogSource> {
                  return std::make_unique<opal::mcap_log::McapLog>(opal::recording::topic_choice(options));
                });
}

}  // namespace

OPAL_PLUGIN("mcap_log", "0.1.0", register_types)
