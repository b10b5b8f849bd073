#include "dxf_importer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

void register_types(opal::Registrar& registrar) {
  registrar.add({"opal:DxfImporter", /*consumes*/ {}, /*produces*/ {"opal:Wall", "opal:Corner", "opal:Column"}},
                opal::Factory<opal::MapImporter>([](const nlohmann::json& options) {
                  return std::make_unique<opal::dxf_importer::DxfImporter>(options);
                }));
}

}  // namespace

OPAL_PLUGIN("dxf_importer", "0.1.0", register_types)
