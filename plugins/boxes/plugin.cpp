#include "detector.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::boxes::BoxOptions options_from(const nlohmann::json& json) {
  opal::boxes::BoxOptions options;
  options.min_side_m = json.at("min_side_m");
  options.max_side_m = json.at("max_side_m");
  options.lines.min_length_m = options.min_side_m;
  options.lines.min_points = json.at("min_points");
  options.lines.tolerance_m = json.at("tolerance_m");
  options.lines.noise.range_sigma_m = json.at("range_sigma_m");
  options.junction.min_sine = json.at("min_sine");
  return options;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::boxes::BoxDetector>({.name = "opal:BoxDetector", .produces = {"opal:PillarCorner"}},
                                          options_from);
}

}  // namespace

OPAL_PLUGIN("boxes", "0.1.0", register_types)
