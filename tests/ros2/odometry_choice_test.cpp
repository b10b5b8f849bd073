#include "ros2/odometry/odometry_comparison.hpp"
#include "ros2/odometry/odometry_patience.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::ros2;

TEST_CASE("transforms are waited for from the first odometry on, and since they are read") {
  OdometryPatience patience;
  CHECK_FALSE(patience.is_over(1e6));  // no driver has started yet
  patience.odometry_is_heard(100);
  patience.odometry_is_heard(102);
  CHECK_FALSE(patience.is_over(102.9));
  CHECK(patience.is_over(103.1));
  patience.transforms_are_read(102);
  CHECK_FALSE(patience.is_over(104.9));
  CHECK(patience.is_over(105.1));
}

TEST_CASE("odometry by messages and by transforms is told where it differs at the same time") {
  OdometryComparison comparison;
  comparison.hear_transform({1, Pose2(5, 0, 0)});
  CHECK(comparison.difference().empty());
  comparison.hear_message({1, Pose2(0, 0, 0)});
  comparison.hear_transform({1.5, Pose2(1, 0, 0)});  // the robot has driven since
  CHECK(comparison.difference().empty());
  comparison.hear_transform({1.02, Pose2(1, 0, 0)});
  CHECK(comparison.difference() == "1.00 m and 0.00 rad");
  comparison.hear_transform({1.04, Pose2(0.1, 0, 0)});
  CHECK(comparison.difference().empty());
}
