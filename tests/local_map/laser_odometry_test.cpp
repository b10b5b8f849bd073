// Wheels whose counts stop arriving while the robot drives on: scans tell where it goes.
#include "local_map/laser_odometry.hpp"
#include "simulation/buildings/building.hpp"
#include "simulation/simulation.hpp"
#include "tests/sensor_health/shipped_matcher.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace opal;

namespace {

constexpr double kStep_s = 0.1;

struct Reading {
  Sample sample;  ///< with odometry that counts everything
  Pose2 T_map_base;
};

/// Curves from a free place in a building. @param starts_s  stands until then.
std::vector<Reading> driven(const std::string& kind, double duration_s, double starts_s = 0) {
  simulation::SimulationOptions options;
  options.people = 2;
  simulation::Simulation robot(simulation::generate_building({kind, 3, 0, 0.5}).map, options, 3);
  Random random(3);
  robot.place(Pose2(robot.floor().anywhere(random), 0));
  std::vector<Reading> readings;
  for (double t = 0; t < duration_s; t += kStep_s) {
    const double forwards_mps = t < starts_s ? 0 : 0.6, turn_radps = t < starts_s ? 0 : 0.5 * std::sin(t / 2);
    if (robot.drive({{forwards_mps, 0}, turn_radps}, kStep_s)) robot.drive({{0, 0}, 0.8}, kStep_s);
    readings.push_back(
        {sample_of(make_scan(robot.scan(), options.laser), robot.T_odom_base(), options.laser.T_base_laser),
         robot.T_map_base()});
  }
  return readings;
}

/// What wheels that stop counting for a while make of a drive, and what becomes of it.
struct Frozen {
  double from_s, to_s;
  double noticed_s;  ///< when the caller says so
};
std::size_t at(double time_s) { return static_cast<std::size_t>(std::lround(time_s / kStep_s)); }

LaserOdometry after(const std::vector<Reading>& readings, const Frozen& frozen, std::vector<Pose2>& T_odom_base) {
  LaserOdometry odometry(shipped_matcher());
  Pose2 T_odom_wheels = readings.front().sample.T_odom_base;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const bool counts = k <= at(frozen.from_s) || k > at(frozen.to_s);
    if (k > 0 && counts)
      T_odom_wheels = T_odom_wheels * (readings[k - 1].sample.T_odom_base.inverse() * readings[k].sample.T_odom_base);
    Sample sample = readings[k].sample;
    sample.T_odom_base = T_odom_wheels;
    odometry.add(sample, !counts && k >= at(frozen.noticed_s));
    T_odom_base.push_back(odometry.at(T_odom_wheels));
  }
  return odometry;
}

/// By how much a motion of the drive is wrong [m].
double error_m(const std::vector<Reading>& readings, const std::vector<Pose2>& T_odom_base, double from_s,
               double to_s) {
  const Pose2 truth = readings[at(from_s)].T_map_base.inverse() * readings[at(to_s)].T_map_base,
              said = T_odom_base[at(from_s)].inverse() * T_odom_base[at(to_s)];
  return distance_m(truth, said);
}

double driven_m(const std::vector<Reading>& readings, double from_s, double to_s) {
  return distance_m(readings[at(from_s)].T_map_base, readings[at(to_s)].T_map_base);
}

}  // namespace

TEST_CASE("motions that the wheels do not count are told by scans, those before it was noticed, too") {
  const std::string kind = GENERATE("office", "hall", "warehouse");
  CAPTURE(kind);
  const std::vector<Reading> readings = driven(kind, 12);
  std::vector<Pose2> T_odom_base;
  const LaserOdometry odometry = after(readings, {3, 9, 4.2}, T_odom_base);
  REQUIRE(driven_m(readings, 3, 9) > 1);
  CHECK(error_m(readings, T_odom_base, 3, 4.1) ==
        Approx(driven_m(readings, 3, 4.1)).margin(0.1));  // nobody has said so
  CHECK(error_m(readings, T_odom_base, 3, 4.2) < 0.1);
  CHECK(error_m(readings, T_odom_base, 3, 9) < 0.2);
  CHECK(error_m(readings, T_odom_base, 9, 11.9) < 0.1);  // the wheels count again
  CHECK(odometry.is_sure());
}

TEST_CASE("odometry that counts is passed on as it is") {
  LaserOdometry odometry(shipped_matcher());
  for (const Reading& reading : driven("office", 5)) {
    odometry.add(reading.sample, false);
    const Pose2 &given = reading.sample.T_odom_base, said = odometry.at(given);
    REQUIRE(said.position() == given.position());
    REQUIRE(said.heading_rad() == given.heading_rad());
  }
}

TEST_CASE("a robot that stands does not move by scans, for however long, nor by a last speed") {
  std::vector<Reading> readings = driven("office", 8, 8);
  for (Reading& reading : readings) reading.sample.T_odom_base = readings.front().sample.T_odom_base;
  std::vector<Pose2> T_odom_base;
  const LaserOdometry odometry = after(readings, {0, 8, 7}, T_odom_base);
  CHECK(odometry.is_sure());
  CHECK(distance_m(T_odom_base.front(), T_odom_base.back()) < 0.05);
}

TEST_CASE("a motion of which the beginning is forgotten is not told") {
  const std::vector<Reading> readings = driven("office", 12);
  std::vector<Pose2> T_odom_base;
  CHECK_FALSE(after(readings, {2, 12, 9}, T_odom_base).is_sure());
}

TEST_CASE("scans that show nothing tell no motion") {
  std::vector<Reading> readings = driven("office", 8);
  for (std::size_t k = at(4); k < readings.size(); ++k) readings[k].sample.views.front().scan.points.clear();
  std::vector<Pose2> T_odom_base;
  CHECK_FALSE(after(readings, {3, 8, 4.2}, T_odom_base).is_sure());
  for (const Pose2& pose : T_odom_base) CHECK(pose.position().allFinite());
}

TEST_CASE("without a matcher the wheels' odometry stays as it is, and nothing tells the motion") {
  const std::vector<Reading> readings = driven("office", 3);
  LaserOdometry odometry(nullptr);
  for (const Reading& reading : readings) {
    Sample sample = reading.sample;
    sample.T_odom_base = Pose2(1, 2, 3);
    odometry.add(sample, true);
  }
  CHECK(distance_m(odometry.at(Pose2(1, 2, 3)), Pose2(1, 2, 3)) == 0);
  CHECK_FALSE(odometry.is_sure());
}
