// What monitors keep and forget, on scans of a round room, without a scan matcher.
#include "sensor_health/sensor_monitors.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

LaserModel laser_named(const std::string& frame) {
  LaserModel laser;
  laser.frame = frame;
  return laser;
}

/// A hundred beams of this range; so many of them hit nothing.
Scan round_scan(double stamp_s, double range_m, int free = 0) {
  Scan scan;
  scan.stamp_s = stamp_s;
  for (int beam = 0; beam < 100; ++beam) {
    const double bearing = 0.06 * beam - 3;
    if (beam < free)
      scan.free_bearings_rad.push_back(bearing);
    else
      scan.points.push_back({range_m * unit_vector(bearing), range_m, bearing, beam});
  }
  return scan;
}

/// Looks from one place after another at ranges that no scan shares with another, but for a farthest one.
void look_about(SensorMonitors& monitors, int places, double apart_m) {
  for (int k = 0; k < places; ++k) {
    Scan scan = round_scan(10 + k, 2 + 0.01 * k);
    for (int beam = 0; beam < 10; ++beam) scan.points[static_cast<std::size_t>(beam)].range_m = 8.5;
    monitors.add(sample_of(scan, Pose2(apart_m * k, 0, 0)));
  }
}

/// Stands by odometry while all that is seen changes.
void freeze(SensorMonitors& monitors, const Pose2& T_odom_base = {}) {
  for (int k = 0; k < 4; ++k) monitors.add(sample_of(round_scan(100 + 1.1 * k, 2 + k), T_odom_base));
}

}  // namespace

TEST_CASE("odometry that has frozen is told, and no longer once it moves") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  CHECK(monitors.contradiction().empty());
  freeze(monitors);
  CHECK(monitors.is_odometry_frozen());
  CHECK_THAT(monitors.contradiction(), Catch::Contains("odometry stands still, but 100 % of the beams have changed"));
  CHECK(monitors.add(sample_of(round_scan(110, 5), Pose2(0.2, 0, 0))));
  CHECK_FALSE(monitors.is_odometry_frozen());
  CHECK(monitors.contradiction().empty());
}

TEST_CASE("what else contradicts its description is told from odometry that has frozen") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  CHECK_FALSE(monitors.only_odometry_stands());
  freeze(monitors);
  CHECK(monitors.only_odometry_stands());
  look_about(monitors, 30, 1);
  freeze(monitors, Pose2(30, 0, 0));
  INFO(monitors.contradiction());
  REQUIRE(monitors.is_odometry_frozen());
  CHECK_FALSE(monitors.only_odometry_stands());
}

TEST_CASE("whoever asks is told once that findings have changed") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  int changes = 0;
  for (int k = 0; k < 6; ++k) changes += monitors.add(sample_of(round_scan(100 + 1.1 * k, 2 + k), Pose2()));
  CHECK(changes == 1);
}

TEST_CASE("ranges count once from one place") {
  SensorMonitors standing({LaserModel()}, nullptr), driving({LaserModel()}, nullptr);
  look_about(standing, 30, 0.002);
  CHECK(standing.findings().empty());
  look_about(driving, 12, 0.11);
  REQUIRE(driving.findings().size() == 1);
  CHECK(driving.findings()[0].subject == SensorFinding::Subject::no_return);
  CHECK(driving.findings()[0].found == 8.5);
}

TEST_CASE("turning on the spot is another place for ranges, too") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  for (int k = 0; k < 12; ++k) monitors.add(sample_of(round_scan(10 + k, 2, 99), Pose2(0, 0, 0.11 * k)));
  REQUIRE(monitors.findings().size() == 1);
  CHECK(monitors.findings()[0].subject == SensorFinding::Subject::usable_beams);
}

TEST_CASE("monitors that are cleared know nothing of before") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  look_about(monitors, 12, 0.2);
  freeze(monitors);
  for (int k = 0; k < 10; ++k) monitors.compare_step(0.15, 0);
  CHECK(monitors.findings().size() == 3);
  monitors.clear();
  CHECK(monitors.findings().empty());
  look_about(monitors, 8, 0.2);
  monitors.add(sample_of(round_scan(105, 9), Pose2()));
  monitors.compare_step(0.15, 0);
  CHECK(monitors.findings().empty());
}

TEST_CASE("of several lasers each is judged by itself, and named") {
  SensorMonitors monitors({laser_named("front"), laser_named("rear")}, nullptr);
  for (int k = 0; k < 4; ++k) {
    Sample sample = sample_of(round_scan(100 + 1.1 * k, 2), Pose2());
    sample.views.push_back({1, round_scan(100 + 1.1 * k, 2 + k), {}});
    sample.views.push_back({7, round_scan(100 + 1.1 * k, 2 + k), {}});  // nobody described it
    monitors.add(sample);
  }
  REQUIRE(monitors.findings().size() == 1);
  CHECK_THAT(monitors.findings()[0].words, Catch::StartsWith("laser rear: "));
  CHECK(monitors.is_odometry_frozen());
}

TEST_CASE("a scan that began before its sample is held against odometry as it was then") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  for (int k = 0; k < 4; ++k) {
    Sample sample = sample_of(round_scan(100 + 1.1 * k, 2 + k), Pose2());
    sample.views[0].T_base_laser = Pose2(-0.1 * k, 0, 0);  // where the laser was, seen from the sample's pose
    monitors.add(sample);
  }
  CHECK_FALSE(monitors.is_odometry_frozen());
}

TEST_CASE("wheels that slip are told beside what the lasers tell, and contradict nothing") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  for (int k = 0; k < 10; ++k) monitors.compare_step(0.15, 0.05);
  REQUIRE(monitors.findings().size() == 1);
  CHECK(monitors.findings()[0].subject == SensorFinding::Subject::odometry_distance);
  CHECK(monitors.contradiction().empty());
}

TEST_CASE("a scan that began before the robot turned is held against odometry as it was then, wherever the laser is") {
  for (const Pose2& mount : {Pose2(), Pose2(0.3, 0.1, 0.5)}) {
    LaserModel laser;
    laser.T_base_laser = mount;
    SensorMonitors monitors({laser}, nullptr);
    for (int k = 0; k < 4; ++k) {
      Sample sample = sample_of(round_scan(100 + 1.1 * k, 2 + k), Pose2());
      sample.views[0].T_base_laser = Pose2(0, 0, -0.1 * k) * mount;
      monitors.add(sample);
    }
    CHECK_FALSE(monitors.is_odometry_frozen());
  }
}

TEST_CASE("odometry is not called frozen for another contradiction") {
  SensorMonitors monitors({LaserModel()}, nullptr);
  look_about(monitors, 30, 0.2);
  REQUIRE_FALSE(monitors.contradiction().empty());
  CHECK_FALSE(monitors.is_odometry_frozen());
}

TEST_CASE("a scan of a laser that nobody described is passed by, whichever number comes after the described ones") {
  for (std::size_t lasers = 1; lasers <= 5; ++lasers) {
    std::vector<LaserModel> described;
    for (std::size_t k = 0; k < lasers; ++k) described.push_back(laser_named("laser " + std::to_string(k)));
    SensorMonitors monitors(described, nullptr);
    bool changed = false;
    for (int k = 0; k < 4; ++k) {
      Sample sample = sample_of(round_scan(100 + 1.1 * k, 2 + k), Pose2());
      sample.views[0].laser = static_cast<int>(lasers);
      changed = monitors.add(sample) || changed;
    }
    CHECK_FALSE(changed);
    CHECK(monitors.findings().empty());
  }
}
