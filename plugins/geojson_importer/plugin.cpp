#include "geojson_importer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::geojson_importer::GeoJsonImporter>(
      {.name = "opal:GeoJsonImporter", .produces = {"opal:Wall", "opal:Corner", "opal:Column"}});
}

}  // namespace

OPAL_PLUGIN("geojson_importer", "0.1.0", register_types)
