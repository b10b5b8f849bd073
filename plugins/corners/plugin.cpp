#include "detector.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::corners::CornerOptions options_from(const nlohmann::json& json) {
  opal::corners::CornerOptions options;
  options.min_arm_m = json.at("min_arm_m");
  options.lines.min_length_m = std::min(options.lines.min_length_m, options.min_arm_m);
  options.lines.min_points = json.at("min_points");
  options.lines.tolerance_m = json.at("tolerance_m");
  options.lines.noise.range_sigma_m = json.at("range_sigma_m");
  options.junction.max_end_distance_m = json.at("max_end_distance_m");
  options.junction.max_extension_m = json.at("max_extension_m");
  options.junction.min_sine = json.at("min_sine");
  return options;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::corners::CornerDetector>({.name = "opal:CornerDetector", .produces = {"opal:Corner"}},
                                               options_from);
}

}  // namespace

OPAL_PLUGIN("corners", "0.1.0", register_types)
