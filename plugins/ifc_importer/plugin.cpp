#include "ifc_importer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::ifc_importer::ImportOptions options_from(const nlohmann::json& options) {
  opal::ifc_importer::ImportOptions chosen;
  chosen.storey = options.at("storey");
  if (!options.at("z_m").is_null()) chosen.z_m = options.at("z_m").get<double>();
  chosen.sensor_height_m = options.at("sensor_height_m");
  chosen.sensor = options.at("sensor");
  chosen.origin_m = {options.at("origin_x_m").get<double>(), options.at("origin_y_m").get<double>()};
  for (const auto& [class_name, word] : options.at("classes").items())
    chosen.classes[class_name] = word.get<std::string>();
  return chosen;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::ifc_importer::IfcImporter>(
      {.name = "opal:IfcImporter", .produces = {"opal:Wall", "opal:Corner", "opal:Column"}}, options_from);
}

}  // namespace

OPAL_PLUGIN("ifc_importer", "0.1.0", register_types)
