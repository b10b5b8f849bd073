#include "dxf_importer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::dxf_importer::DxfImporter>(
      {.name = "opal:DxfImporter", .produces = {"opal:Wall", "opal:Corner", "opal:Column"}});
}

}  // namespace

OPAL_PLUGIN("dxf_importer", "0.1.0", register_types)
