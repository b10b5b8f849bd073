#include "grid_importer.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::grid_importer::VectorizerLimits limits_from(const nlohmann::json& options) {
  opal::grid_importer::VectorizerLimits limits;
  limits.bridge_gap_m = options.at("bridge_gap_m");
  limits.line_tolerance_m = options.at("line_tolerance_m");
  limits.min_face_m = options.at("min_face_m");
  limits.max_column_radius_m = options.at("max_column_radius_m");
  limits.thicken_m = options.at("thicken_m");
  return limits;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::grid_importer::GridImporter>(
      {.name = "opal:GridImporter", .produces = {"opal:Wall", "opal:Corner", "opal:Column"}}, limits_from);
}

}  // namespace

OPAL_PLUGIN("grid_importer", "0.1.0", register_types)
