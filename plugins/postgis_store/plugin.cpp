#include "postgis_store.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

std::unique_ptr<opal::MapStore> make_store(const nlohmann::json& options) {
  opal::postgis_store::ServerOptions server;
  server.connect_timeout_s = options.at("connect_timeout_s");
  server.lock_timeout_s = options.at("lock_timeout_s");
  return std::make_unique<opal::postgis_store::PostgisStore>(server);
}

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:PostgisStore", /*consumes*/ {}, /*produces*/ {}}, opal::Factory<opal::MapStore>(make_store));
}

}  // namespace

OPAL_PLUGIN("postgis_store", "0.1.0", register_types)
