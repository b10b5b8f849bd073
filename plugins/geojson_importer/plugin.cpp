#include "geojson_importer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:GeoJsonImporter", /*consumes*/ {}, /*produces*/ {"opal:Wall", "opal:Corner", "opal:Column"}},
                opal::Factory<opal::MapImporter>([](const nlohmann::json& options) {
                  return std::make_unique<opal::geojson_importer::GeoJsonImporter>(options);
                }));
}

}  // namespace

OPAL_PLUGIN("geojson_importer", "0.1.0", register_types)
