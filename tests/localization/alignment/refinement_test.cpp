// How a guess holds an alignment with the map.
#include "localization/alignment/registration.hpp"
#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::synthetic;

namespace {

const Pose2 kTruth(4, 4.5, 0.3), kGuess = kTruth * Pose2(0.05, 0.03, 0.04);

Alignment aligned(double prior_position, double prior_heading) {
  const auto map = view_of(room());
  const Robot robot(map, kTruth);
  RefinementOptions options;
  options.prior_position = prior_position;
  options.prior_heading = prior_heading;
  return align_with_map(*map, robot.observation().scans, kGuess, options);
}

}  // namespace

TEST_CASE("a guess weighs as many of a scan's points as is asked for, in position and in heading") {
  const auto map = view_of(room());
  const auto points = static_cast<double>(Robot(map, kTruth).observation().points());
  const Eigen::Vector3d expected(0.25 * points, 0.25 * points, 0.5 * points);
  CHECK(aligned(0.25, 0.5).by_guess.isApprox(Eigen::Matrix3d(expected.asDiagonal())));
}

TEST_CASE("the more a guess weighs, the less an alignment leaves it, each of position and heading by itself") {
  const Pose2 by_points = aligned(0, 0).T_map_base, by_heading = aligned(0, 1e4).T_map_base,
              by_position = aligned(1e4, 0).T_map_base;
  CHECK(distance_m(by_points, kTruth) < 0.01);
  CHECK(angle_between_rad(by_points, kTruth) < 0.005);
  CHECK(angle_between_rad(by_heading, kGuess) < 0.001);
  CHECK(distance_m(by_heading, kGuess) > 0.02);
  CHECK(distance_m(by_position, kGuess) < 0.001);
  CHECK(angle_between_rad(by_position, kGuess) > 0.02);
}
