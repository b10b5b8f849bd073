#include "detector.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::circles::CircleOptions options_from(const nlohmann::json& json) {
  opal::circles::CircleOptions options;
  options.min_radius_m = json.at("min_radius_m");
  options.max_radius_m = json.at("max_radius_m");
  options.min_points = json.at("min_points");
  options.max_rms_m = json.at("max_rms_m");
  options.min_jump_m = json.at("min_jump_m");
  options.max_radius_sigma_m = json.at("max_radius_sigma_m");
  options.noise.range_sigma_m = json.at("range_sigma_m");
  return options;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::circles::CircleDetector>({.name = "opal:CircleDetector", .produces = {"opal:Column"}},
                                               options_from);
}

}  // namespace

OPAL_PLUGIN("circles", "0.1.0", register_types)
