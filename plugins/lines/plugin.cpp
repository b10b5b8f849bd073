#include "detector.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::LineExtractionOptions options_from(const nlohmann::json& json) {
  opal::LineExtractionOptions options;
  options.min_points = json.at("min_points");
  options.min_length_m = json.at("min_length_m");
  options.tolerance_m = json.at("tolerance_m");
  options.tolerance_per_m = json.at("tolerance_per_m");
  options.chain.gap_m = json.at("chain_gap_m");
  options.max_hidden_gap_m = json.at("max_hidden_gap_m");
  options.max_open_gap_m = json.at("max_open_gap_m");
  options.max_offset_m = json.at("max_offset_m");
  options.max_angle_rad = json.at("max_angle_rad");
  options.noise.range_sigma_m = json.at("range_sigma_m");
  return options;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::lines::LineDetector>({.name = "opal:LineDetector", .produces = {"opal:Wall"}}, options_from);
}

}  // namespace

OPAL_PLUGIN("lines", "0.1.0", register_types)
