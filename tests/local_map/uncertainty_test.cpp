#include <opal/local_map/local_map.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace opal;

namespace {

/// Keeps what it was asked, and never finds anything.
struct AskedMatcher : ScanMatcher {
  mutable Pose2 guess;
  mutable Eigen::Vector3d sigma = Eigen::Vector3d::Zero();
  ScanMatch match(std::span<const Point>, std::span<const Point>, const Pose2& T_guess,
                  const Eigen::Vector3d& guess_sigma) const override {
    guess = T_guess;
    sigma = guess_sigma;
    return {};
  }
};

Sample one_point_from(const Pose2& T_odom_base) {
  Scan scan;
  scan.points.push_back({{1, 1}, std::sqrt(2.0), 0.8, 0});
  return sample_of(scan, T_odom_base);
}

Feature column_with(const Eigen::Matrix3d& covariance) { return {"opal:Column", Circle{{3, 1}, 0.2}, covariance}; }

Eigen::Matrix3d covariance_kept(const Eigen::Matrix3d& detected) {
  LocalMap map({}, nullptr);
  map.add(sample_of({}, Pose2()), {column_with(detected)});
  return map.features().at(0).measurements.at(0).feature.covariance;
}

}  // namespace

TEST_CASE("a matcher is told where odometry has the robot, and how well it knows after so much driving and turning") {
  const auto matcher = std::make_shared<AskedMatcher>();
  LocalMapOptions options;
  options.odometry_sigma_m = 0.03;
  options.odometry_sigma_per_m = 0.02;
  options.odometry_heading_sigma_rad = 0.02;
  options.odometry_heading_sigma_per_rad = 0.2;
  options.odometry_heading_sigma_per_m = 0.045;
  LocalMap map(options, matcher);
  map.add(one_point_from(Pose2(5, 1, 0)), {});
  map.add(one_point_from(Pose2(5, 3, 0.3)), {});
  CHECK(distance_m(matcher->guess, Pose2(0, 2, 0.3)) < 1e-12);
  CHECK(matcher->sigma.x() == Approx(0.05));  // 0.03 and 2 x 0.02
  CHECK(matcher->sigma.y() == Approx(0.05));
  CHECK(matcher->sigma.z() == Approx(0.11));  // 0.02, 0.3 x 0.2 and 2 x 0.045
}

TEST_CASE("where nothing is matched, the last match is where odometry has the robot") {
  LocalMap map({}, nullptr);
  map.add(one_point_from(Pose2(5, 1, 0)), {});
  map.add(one_point_from(Pose2(6, 3, 0.3)), {});
  CHECK_FALSE(map.last_match().converged);
  CHECK(distance_m(map.last_match().T_reference_scan, Pose2(1, 2, 0)) < 1e-12);
}

TEST_CASE("a match that did not converge says no more than odometry") {
  LocalMap map({}, std::make_shared<AskedMatcher>());  // its covariance is zero
  map.add(one_point_from(Pose2(5, 1, 0)), {});
  map.add(one_point_from(Pose2(6, 3, 0)), {});
  CHECK(std::sqrt(map.last_match().covariance(0, 0)) == Approx(std::hypot(0.06, 0.15 * std::sqrt(5.0))));
  CHECK(std::sqrt(map.last_match().covariance(2, 2)) > LocalMapOptions{}.odometry_heading_sigma_rad);
}

TEST_CASE("a covariance that is none is made one: symmetric, and without what would be negative variances") {
  Eigen::Matrix3d lopsided = 4e-4 * Eigen::Matrix3d::Identity();
  lopsided(0, 1) = 2e-4;
  Eigen::Matrix3d even = lopsided;
  even(0, 1) = even(1, 0) = 1e-4;
  CHECK(covariance_kept(lopsided).isApprox(even));
  CHECK(covariance_kept(even).isApprox(even));
  Eigen::Matrix3d impossible = even;
  impossible(0, 1) = impossible(1, 0) = 9e-4;  // correlated by more than one
  CHECK(covariance_kept(impossible).isApprox(4e-4 * Eigen::Matrix3d::Identity()));
}
