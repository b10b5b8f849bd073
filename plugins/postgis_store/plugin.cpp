#include "postgis_store.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::postgis_store::ServerOptions server_from(const nlohmann::json& options) {
  opal::postgis_store::ServerOptions server;
  server.connect_timeout_s = options.at("connect_timeout_s");
  server.lock_timeout_s = options.at("lock_timeout_s");
  return server;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::postgis_store::PostgisStore>({.name = "opal:PostgisStore"}, server_from);
}

}  // namespace

OPAL_PLUGIN("postgis_store", "0.1.0", register_types)
