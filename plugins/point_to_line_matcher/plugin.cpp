#include "matcher.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::point_to_line::MatcherOptions options_from(const nlohmann::json& json) {
  opal::point_to_line::MatcherOptions options;
  options.max_points = json.at("max_points");
  options.search_points = json.at("search_points");
  options.search_sigmas = json.at("search_sigmas");
  options.min_inlier_share = json.at("min_inlier_share");
  options.refinement.iterations = json.at("iterations");
  options.refinement.point_sigma_m = json.at("point_sigma_m");
  options.refinement.inlier_distance_m = json.at("inlier_distance_m");
  options.refinement.robust_scale_m = json.at("robust_scale_m");
  return options;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::point_to_line::PointToLineMatcher>({.name = "opal:PointToLineMatcher"}, options_from);
}

}  // namespace

OPAL_PLUGIN("point_to_line_matcher", "0.1.0", register_types)
