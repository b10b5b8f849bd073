// A simulated robot drives in a generated building; what is described of it is right, or wrong in one way.
#include "sensor_health/sensor_monitors.hpp"
#include "shipped_matcher.hpp"
#include "simulation/buildings/building.hpp"
#include "simulation/simulation.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

using Subject = SensorFinding::Subject;
using Verdict = SensorFinding::Verdict;

/// What a drive gives to a monitor: the reading, and odometry.
struct Reading {
  RawScan scan;
  Pose2 T_odom_base;
};

/// Half a minute of curves from the middle of a building.
std::vector<Reading> driven(const LaserModel& laser, const std::string& kind, std::uint64_t seed) {
  simulation::SimulationOptions options;
  options.laser = laser;
  options.people = 2;
  simulation::Simulation robot(simulation::generate_building({kind, seed, 0, 0.5}).map, options, seed);
  Random random(seed);
  robot.place(Pose2(robot.floor().anywhere(random), 0));
  std::vector<Reading> readings;
  for (int step = 0; step < 300; ++step) {
    const double turn_radps = std::sin(step / 25.0) * 0.6;
    if (robot.drive({{0.6, 0}, turn_radps}, 0.1)) robot.drive({{0, 0}, 0.8}, 0.5);
    readings.push_back({robot.scan(), robot.T_odom_base()});
  }
  return readings;
}

/// Straight on between two walls without end.
std::vector<Reading> driven_along_a_bare_corridor(const LaserModel& laser, double length_m) {
  constexpr double kHalfWidth_m = 1.2, kStep_m = 0.1;
  std::vector<Reading> readings;
  for (int step = 0; step * kStep_m < length_m; ++step) {
    Reading reading{{}, Pose2(step * kStep_m, 0, 0)};
    reading.scan.stamp_s = 1000 + step * 0.1;
    for (int beam = 0; beam < laser.beams; ++beam) {
      const double across = std::abs(std::sin(laser.angle_min_rad + beam * laser.angle_increment_rad));
      const double range_m = across > 1e-3 ? kHalfWidth_m / across : 1e3;
      reading.scan.ranges_m.push_back(static_cast<float>(range_m < laser.range_max_m ? range_m : laser.no_return_m));
    }
    readings.push_back(std::move(reading));
  }
  return readings;
}

/// Half a minute whose readings were changed on the way, each by the same mistake.
template <class Change>
std::vector<Reading> driven_with(const std::string& kind, const Change& change) {
  std::vector<Reading> readings = driven(simulation::SimulationOptions::default_laser(), kind, 1);
  for (Reading& reading : readings) change(reading);
  return readings;
}

SensorMonitors watched(const std::vector<Reading>& readings, const LaserModel& described) {
  SensorMonitors monitor({described}, shipped_matcher());
  for (const Reading& reading : readings)
    monitor.add(sample_of(make_scan(reading.scan, described), reading.T_odom_base, described.T_base_laser));
  return monitor;
}

bool contradicts(const SensorMonitors& monitor, Subject subject) {
  const auto& all = monitor.findings();
  return std::ranges::any_of(all, [&](const SensorFinding& finding) {
    return finding.subject == subject && finding.verdict == Verdict::contradicted;
  });
}

std::string words(const SensorMonitors& monitor) {
  std::string text;
  for (const SensorFinding& finding : monitor.findings()) text += finding.words + '\n';
  return text;
}

LaserModel true_laser() { return simulation::SimulationOptions::default_laser(); }

}  // namespace

TEST_CASE("a description that is right is found fine, whatever the building") {
  const std::string kind = GENERATE("office", "hall", "warehouse", "corridor");
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SensorMonitors monitor = watched(driven(true_laser(), kind, seed), true_laser());
    INFO(kind << " " << seed << ":\n" << words(monitor));
    CHECK(monitor.contradiction().empty());
  }
}

TEST_CASE("a laser that is mounted backwards is noticed") {
  LaserModel described = true_laser();
  described.T_base_laser = Pose2(described.T_base_laser.position(), described.T_base_laser.heading_rad() + 3.14);
  const std::string kind = GENERATE("office", "hall", "warehouse", "corridor");
  SensorMonitors monitor = watched(driven(true_laser(), kind, 1), described);
  INFO(words(monitor));
  CHECK(contradicts(monitor, Subject::mount_heading));
  CHECK_THAT(monitor.contradiction(), Catch::Contains("backwards"));
}

TEST_CASE("what contradicted a description stands where motions tell nothing of it, and falls where they agree") {
  LaserModel backwards = true_laser();
  backwards.T_base_laser = Pose2(backwards.T_base_laser.position(), 3.14);
  std::vector<Reading> readings = driven(true_laser(), "office", 1);
  const auto in_a_corridor = driven_along_a_bare_corridor(true_laser(), 30);
  readings.insert(readings.end(), in_a_corridor.begin(), in_a_corridor.end());
  CHECK(contradicts(watched(readings, backwards), Subject::mount_heading));

  const LaserModel right = true_laser();
  std::vector<Reading> righted = driven(backwards, "office", 1);
  for (const auto& more : {in_a_corridor, driven(right, "office", 2)})
    righted.insert(righted.end(), more.begin(), more.end());
  SensorMonitors monitor = watched(righted, right);
  INFO(words(monitor));
  CHECK(monitor.contradiction().empty());
}

TEST_CASE("a bare corridor says nothing against a description, nor for it") {
  const bool is_backwards = GENERATE(false, true);
  LaserModel described = true_laser();
  if (is_backwards) described.T_base_laser = Pose2(described.T_base_laser.position(), 3.14);
  SensorMonitors monitor = watched(driven_along_a_bare_corridor(true_laser(), 30), described);
  INFO(words(monitor));
  for (const SensorFinding& finding : monitor.findings()) CHECK(finding.subject != Subject::mount_heading);
}

TEST_CASE("a robot that stands in a crowd is not one whose odometry has frozen") {
  const std::string kind = GENERATE("office", "hall", "corridor", "warehouse");
  simulation::SimulationOptions options;
  options.people = 60;
  simulation::Simulation robot(simulation::generate_building({kind, 1, 0, 0.5}).map, options, 1);
  Random random(1);
  robot.place(Pose2(robot.floor().anywhere(random), 0));
  SensorMonitors monitor({true_laser()}, shipped_matcher());
  int frozen = 0;
  for (int step = 0; step < 600; ++step) {
    robot.drive({{0, 0}, 0}, 0.1);
    monitor.add(sample_of(make_scan(robot.scan(), true_laser()), robot.T_odom_base(), true_laser().T_base_laser));
    frozen += contradicts(monitor, Subject::standing_odometry) ? 1 : 0;
  }
  INFO(kind);
  CHECK(frozen == 0);
}

TEST_CASE("a laser that is turned by 30 degrees is noticed") {
  LaserModel described = true_laser();
  described.angle_min_rad += 0.52;
  SensorMonitors monitor = watched(driven(true_laser(), "office", 1), described);
  INFO(words(monitor));
  CHECK(contradicts(monitor, Subject::mount_heading));
}

TEST_CASE("beams that turn the other way are noticed") {
  const auto readings = driven_with("office", [](Reading& reading) { std::ranges::reverse(reading.scan.ranges_m); });
  SensorMonitors monitor = watched(readings, true_laser());
  INFO(words(monitor));
  CHECK(contradicts(monitor, Subject::mirroring));
}

TEST_CASE("odometry in other units is noticed") {
  const auto readings = driven_with("office", [](Reading& reading) {
    reading.T_odom_base = Pose2(3.28 * reading.T_odom_base.position(), reading.T_odom_base.heading_rad());
  });
  SensorMonitors monitor = watched(readings, true_laser());
  INFO(words(monitor));
  CHECK(contradicts(monitor, Subject::odometry_distance));
}

TEST_CASE("odometry that never comes is noticed") {
  const std::string kind = GENERATE("office", "hall", "warehouse", "corridor");
  const auto readings = driven_with(kind, [](Reading& reading) { reading.T_odom_base = Pose2(); });
  SensorMonitors monitor = watched(readings, true_laser());
  INFO(words(monitor));
  CHECK(contradicts(monitor, Subject::standing_odometry));
}

TEST_CASE("a range that stands for no return, and is described as a hit, is noticed") {
  const auto readings = driven_with("hall", [](Reading& reading) {
    for (float& range_m : reading.scan.ranges_m) range_m = std::min(range_m, 5.6f);
  });
  SensorMonitors monitor = watched(readings, true_laser());
  INFO(words(monitor));
  CHECK(contradicts(monitor, Subject::no_return));
  CHECK_THAT(monitor.contradiction(), Catch::Contains("5.6"));
  LaserModel right = true_laser();
  right.no_return_m = 5.6;
  CHECK_FALSE(contradicts(watched(readings, right), Subject::no_return));
}

TEST_CASE("ranges in millimetres are noticed") {
  const auto readings = driven_with("hall", [](Reading& reading) {
    for (float& range_m : reading.scan.ranges_m) range_m *= 1000;
  });
  CHECK(contradicts(watched(readings, true_laser()), Subject::usable_beams));
}

TEST_CASE("empty scans, NaN and a robot that stands say nothing") {
  SensorMonitors monitor({true_laser()}, shipped_matcher());
  Scan nan;
  nan.points.push_back({{NAN, NAN}, NAN, NAN, 0});
  for (int k = 0; k < 50; ++k) {
    monitor.add(sample_of({}, Pose2()));
    monitor.add(sample_of(nan, Pose2(NAN, 0, 0)));
  }
  CHECK(monitor.contradiction().empty());
}
