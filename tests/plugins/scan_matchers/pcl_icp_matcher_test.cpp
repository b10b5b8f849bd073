#include "room.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <catch2/catch.hpp>

#include <limits>

using namespace opal;

namespace {
const Eigen::Vector3d kSigma(0.15, 0.15, 0.1);

std::shared_ptr<const ScanMatcher> pcl_matcher() {
  PluginRegistry registry;
  registry.load(OPAL_PLUGIN_DIR "/pcl_icp_matcher.so");
  return registry.make<ScanMatcher>("opal:PclIcpMatcher");
}
}  // namespace

TEST_CASE("the PCL matcher improves a guess that is off by centimetres and degrees") {
  std::mt19937 random(7);
  const auto matcher = pcl_matcher();
  const Pose2 first(1.2, 3.2, 0.1), motion(0.3, 0, 0.1);
  const auto reference = room::scan(room::office(), first, 0.02, random);
  const auto scan = room::scan(room::office(), first * motion, 0.02, random);
  const ScanMatch match = matcher->match(reference, scan, motion * Pose2(0.08, -0.06, 0.04), kSigma);
  REQUIRE(match.converged);
  CHECK(distance_m(match.T_reference_scan, motion) < 0.04);
  CHECK(angle_between_rad(match.T_reference_scan, motion) < 0.015);
  CHECK(match.covariance.diagonal().minCoeff() > 0);
}

TEST_CASE("the PCL matcher takes poor points for ordinary") {
  std::mt19937 random(8);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto matcher = pcl_matcher();
  auto scan = room::scan(room::office(), Pose2(1.2, 3.2, 0.1), 0.02, random);
  const std::vector<Point> none, same(50, Point(1, 1));
  CHECK_FALSE(matcher->match(none, scan, Pose2(), kSigma).converged);
  CHECK_FALSE(matcher->match(scan, none, Pose2(), kSigma).converged);
  CHECK_FALSE(matcher->match(scan, scan, Pose2(500, 0, 0), kSigma).converged);
  CHECK(matcher->match(same, same, Pose2(), kSigma).T_reference_scan.position().allFinite());
  const auto clean = scan;
  scan[10] = Point(nan, 1);
  CHECK(matcher->match(clean, scan, Pose2(), kSigma).converged);
}
