#include "mcap_log.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::mcap_log::McapLog>({.name = "opal:McapLog"}, opal::recording::topic_choice);
}

}  // namespace

OPAL_PLUGIN("mcap_log", "0.1.0", register_types)
