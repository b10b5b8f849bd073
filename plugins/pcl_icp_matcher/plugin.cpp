#include "matcher.hpp"

#include <opal/plugin/plugin.hpp>

namespace {

opal::pcl_icp::MatcherOptions options_from(const nlohmann::json& json) {
  opal::pcl_icp::MatcherOptions options;
  options.max_points = json.at("max_points");
  options.iterations = json.at("iterations");
  options.correspondence_m = json.at("correspondence_m");
  options.inlier_distance_m = json.at("inlier_distance_m");
  options.min_inlier_share = json.at("min_inlier_share");
  options.point_sigma_m = json.at("point_sigma_m");
  return options;
}

void register_types(opal::Registrar& registrar) {
  registrar.add<opal::pcl_icp::PclIcpMatcher>({.name = "opal:PclIcpMatcher"}, options_from);
}

}  // namespace

OPAL_PLUGIN("pcl_icp_matcher", "0.1.0", register_types)
