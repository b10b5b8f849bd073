#include <opal/sensing/odometry_scale.hpp>

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("odometry without scales passes through to the last bit") {
  ScaledOdometry odometry;
  for (double k = 0; k < 5; ++k) {
    const Pose2 reading(0.1 * k, 0.3, 0.7 * k), passed = odometry.next(reading);
    CHECK(passed.position() == reading.position());
    CHECK(passed.heading_rad() == reading.heading_rad());
  }
}

TEST_CASE("distances and turns are scaled step by step, along the robot's own heading") {
  ScaledOdometry odometry({2, 0.5});
  odometry.next(Pose2(1, 1, 0));
  const Pose2 turned = odometry.next(Pose2(2, 1, 1));  // a metre ahead, then a radian to the left
  CHECK(turned.x() == Approx(3));
  CHECK(turned.heading_rad() == Approx(0.5));
  const Pose2 ahead = Pose2(2, 1, 1) * Pose2(1, 0, 0);
  CHECK(distance_m(odometry.at(ahead), turned * Pose2(2, 0, 0)) == Approx(0).margin(1e-12));
  CHECK(distance_m(odometry.next(ahead), turned * Pose2(2, 0, 0)) == Approx(0).margin(1e-12));
}
