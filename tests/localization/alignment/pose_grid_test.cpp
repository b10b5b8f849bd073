#include "localization/alignment/pose_grid.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace opal;

namespace {

const Pose2 kCenter(5, -2, 0.3);

std::vector<Pose2> poses_of(const PoseGrid& grid) {
  std::vector<Pose2> poses;
  for_each_pose(kCenter, grid, [&](const Pose2& pose, const GridSteps&) { poses.push_back(pose); });
  return poses;
}

}  // namespace

TEST_CASE("a grid of poses reaches as far as it shall, and has its centre") {
  const std::vector<Pose2> poses = poses_of(PoseGrid::covering(0.25, 0.05, 0.1, 0.03));
  REQUIRE(poses.size() == 7 * 7 * 5);
  const Pose2& middle = poses[poses.size() / 2];
  CHECK(distance_m(middle, kCenter) == 0);
  CHECK(angle_between_rad(middle, kCenter) == 0);
  CHECK(poses.front().x() == Approx(4.7));
  CHECK(poses.front().y() == Approx(-2.3));
  CHECK(poses.front().heading_rad() == Approx(0.24));
  CHECK(poses.back().x() == Approx(5.3));
  CHECK(poses.back().heading_rad() == Approx(0.36));
}

TEST_CASE("a grid that need not reach anywhere is its centre") {
  CHECK(poses_of(PoseGrid::covering(0, 0, 0.1, 0.03)).size() == 1);
}

TEST_CASE("poses of a grid come by heading, then by x, then by y, and with their steps") {
  std::vector<std::vector<int>> order;
  for_each_pose(kCenter, {0.1, 0.03, 1, 1}, [&](const Pose2& pose, const GridSteps& steps) {
    order.push_back({steps.turn, steps.x, steps.y});
    CHECK(pose.x() == Approx(kCenter.x() + 0.1 * steps.x));
    CHECK(pose.y() == Approx(kCenter.y() + 0.1 * steps.y));
    CHECK(pose.heading_rad() == Approx(kCenter.heading_rad() + 0.03 * steps.turn));
  });
  CHECK(order.size() == 27);
  CHECK(std::is_sorted(order.begin(), order.end()));
}
