// What a monitor saw before it was cleared says nothing of what it sees after.
#include "sensor_health/sensor_monitor.hpp"
#include "shipped_matcher.hpp"
#include "simulation/buildings/building.hpp"
#include "simulation/simulation.hpp"

#include <catch2/catch.hpp>

using namespace opal;

namespace {

struct Taken {
  Scan scan;
  Pose2 T_odom_base;
};

LaserModel usual_laser() { return simulation::SimulationOptions::default_laser(); }

/// Ten seconds in an office; all drives begin at the same time.
std::vector<Taken> drive(double speed_mps, double turn_radps, std::uint64_t seed) {
  simulation::SimulationOptions options;
  options.laser = usual_laser();
  options.people = 0;
  simulation::Simulation robot(simulation::generate_building({"office", 1, 0, 0.5}).map, options, seed);
  Random random(seed);
  robot.place(Pose2(robot.floor().anywhere(random), 0));
  std::vector<Taken> readings;
  for (int step = 0; step < 100; ++step) {
    if (robot.drive({{speed_mps, 0}, turn_radps}, 0.1)) robot.drive({{0, 0}, 0.8}, 0.5);
    readings.push_back({make_scan(robot.scan(), usual_laser()), robot.T_odom_base()});
  }
  return readings;
}

std::vector<Taken> without_odometry(std::vector<Taken> readings) {
  for (Taken& reading : readings) reading.T_odom_base = Pose2();
  return readings;
}

std::vector<Taken> cut_off_at(double range_m, std::vector<Taken> readings) {
  for (Taken& reading : readings)
    for (ScanPoint& point : reading.scan.points) {
      point.range_m = std::min(point.range_m, range_m);
      point.position = point.range_m * unit_vector(point.bearing_rad);
    }
  return readings;
}

const std::vector<std::vector<Taken>>& drives() {
  static const std::vector<std::vector<Taken>> all{
      drive(0, 0, 1), drive(0.6, 0.3, 2), without_odometry(drive(0.6, 0.4, 3)), cut_off_at(2.5, drive(0.6, 0.3, 4))};
  return all;
}

}  // namespace

TEST_CASE("a monitor that was cleared says of any drive what a new one says, scan by scan") {
  const std::size_t first = GENERATE(0u, 1u, 2u, 3u), second = GENERATE(0u, 1u, 2u, 3u);
  CAPTURE(first, second);
  SensorMonitor cleared(usual_laser(), shipped_matcher()), fresh(usual_laser(), shipped_matcher());
  for (const Taken& before : drives()[first]) cleared.add(before.scan, before.T_odom_base);
  cleared.clear();
  CHECK(cleared.findings().empty());
  int different = 0;
  for (const Taken& now : drives()[second]) {
    const bool changed = cleared.add(now.scan, now.T_odom_base);
    different += changed != fresh.add(now.scan, now.T_odom_base);
    different += !std::equal(cleared.findings().begin(), cleared.findings().end(), fresh.findings().begin(),
                             fresh.findings().end(), [](const SensorFinding& a, const SensorFinding& b) {
                               return a.subject == b.subject && a.verdict == b.verdict && a.words == b.words;
                             });
  }
  CHECK(different == 0);
}

TEST_CASE("of those drives, most tell something") {
  int told = 0;
  for (const std::vector<Taken>& readings : drives()) {
    SensorMonitor monitor(usual_laser(), shipped_matcher());
    for (const Taken& reading : readings) monitor.add(reading.scan, reading.T_odom_base);
    told += monitor.findings().empty() ? 0 : 1;
  }
  CHECK(told >= 3);
}
