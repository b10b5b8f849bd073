#include "ros2/odometry/odom_frame.hpp"

#include <catch2/catch.hpp>

using namespace opal::ros2;

TEST_CASE("the transform leads to the frame that messages of odometry name, unless an option states another one") {
  CHECK(odom_frame_of("odom", false, "robot1/odom").frame == "robot1/odom");
  CHECK(odom_frame_of("odom", true, "robot1/odom").frame == "odom");
  CHECK_FALSE(odom_frame_of("odom", true, "robot1/odom").words.empty());
}

TEST_CASE("of a frame of odometry about which all agree nothing is said") {
  CHECK(odom_frame_of("odom", true, "odom").words.empty());
  CHECK(odom_frame_of("odom", false, "").frame == "odom");
  CHECK(odom_frame_of("odom", false, "").words.empty());
}
