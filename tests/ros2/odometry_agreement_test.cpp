#include "ros2/odometry/odometry_agreement.hpp"

#include <catch2/catch.hpp>

using namespace opal;
using namespace opal::ros2;
using Catch::Matchers::Contains;

namespace {

/// A robot that drives along an arc at 0.5 m/s and turns 0.2 rad/s, as one of its sources says.
OdometrySource source(const std::string& name, double scale = 1, double every_s = 0.02, double from_s = 100,
                      double to_s = 110) {
  OdometrySource made{name, "odom", "base_link", {}};
  for (double s = from_s; s <= to_s; s += every_s) {
    const double heading_rad = 0.2 * (s - 100);
    made.T_odom_base.push_back(
        {s, Pose2(scale * 2.5 * std::sin(heading_rad), scale * 2.5 * (1 - std::cos(heading_rad)), heading_rad)});
  }
  return made;
}

}  // namespace

TEST_CASE("two sources that move alike agree, whatever their rates, and whichever begins later") {
  CHECK(disagreements(source("/tf"), source("/odom")).empty());
  CHECK(disagreements(source("/tf", 1, 0.02), source("/odom", 1, 0.2)).empty());
  CHECK(disagreements(source("/tf", 1, 0.02), source("/odom", 1, 0.05, 104)).empty());
  CHECK(disagreements(source("/tf"), source("/odom", 1.04)).empty());
}

TEST_CASE("jitter of one source is no way") {
  OdometrySource shaken = source("/tf");
  for (std::size_t k = 0; k < shaken.T_odom_base.size(); k += 2)
    shaken.T_odom_base[k].pose = shaken.T_odom_base[k].pose * Pose2(0, 0.005, 0);
  CHECK(disagreements(shaken, source("/odom")).empty());
}

TEST_CASE("two sources that differ by more than 5 % are told with both numbers, and with the one that is used") {
  const auto words = disagreements(source("the transform on /tf"), source("/odom", 1.1));
  REQUIRE(words.size() == 1);
  CHECK_THAT(words[0], Contains("differs by more than 5 %: the transform on /tf says 5.00 m"));
  CHECK_THAT(words[0], Contains("/odom says 5.50 m"));
  CHECK_THAT(words[0], Contains("Opal uses the transform on /tf"));
}

TEST_CASE("turns that differ are told, too") {
  OdometrySource turned = source("/odom");
  for (StampedPose& pose : turned.T_odom_base)
    pose.pose = Pose2(pose.pose.x(), pose.pose.y(), 1.2 * pose.pose.heading_rad());
  CHECK(disagreements(source("/tf"), turned).size() == 1);
}

TEST_CASE("other frames are told by their names") {
  OdometrySource other = source("/odom");
  other.base_frame = "base_footprint";
  const auto words = disagreements(source("the transform on /tf"), other);
  REQUIRE(words.size() == 1);
  CHECK_THAT(words[0], Contains("/odom says where base_footprint is in odom"));
}

TEST_CASE("a robot that stands, and stamps of two clocks, tell nothing of the motion, and this is said") {
  OdometrySource still = source("/tf"), also = source("/odom");
  for (StampedPose& pose : still.T_odom_base) pose.pose = Pose2();
  for (StampedPose& pose : also.T_odom_base) pose.pose = Pose2(3, 0, 0);
  CHECK_THAT(disagreements(still, also).at(0), Contains("hardly moved"));
  CHECK_THAT(disagreements(source("/tf"), source("/odom", 1, 0.02, 500, 510)).at(0), Contains("by their stamps"));
  for (StampedPose& pose : also.T_odom_base) pose.stamp_s = 0;
  CHECK(disagreements(source("/tf"), also).empty());
}
