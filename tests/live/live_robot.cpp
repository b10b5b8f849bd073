#include "live_robot.hpp"

#include "tests/kit/shipped_plugins.hpp"

#include "simulation/buildings/building.hpp"

#include <opal/deployment/deployment.hpp>

#include <algorithm>

using namespace opal;

namespace {

Deployment deployment() { return read_deployment(OPAL_SOURCE_DIR "/configs/two_lasers.jsonld"); }

}  // namespace

const LiveRobot& robot() {
  static const LiveRobot one;
  return one;
}

std::vector<LaserModel> front_and_rear() { return deployment().lasers; }

LiveRobot::LiveRobot(double duration_s) : LiveRobot(front_and_rear(), 0.1, duration_s) {}

LiveRobot::LiveRobot(std::vector<LaserModel> lasers_given, double scan_every_s, double duration_s)
    : map(simulation::generate_building({"hall", 3, 800, 0.2}).map), lasers(std::move(lasers_given)) {
  simulation::SimulationOptions world;
  world.laser = lasers.front();
  world.more_lasers = {lasers.back()};
  world.people = 1;
  simulation::Simulation simulation(map, world, 5);
  simulation::DriveOptions drive;
  drive.scan_every_s = scan_every_s;
  Random random(5);
  std::vector<Point> places;
  for (int k = 0; k < 6; ++k) places.push_back(simulation.floor().anywhere(random));
  recording = simulation::record_route(simulation, places, duration_s, drive, random.branch());
  arrivals = simulation::arrivals_of(simulation::records_of(recording), *lasers.front().sweep_s);
}

LocalizerParts LiveRobot::parts() const { return parts(lasers); }

LocalizerParts LiveRobot::parts(std::vector<LaserModel> described) const {
  return build_parts(with_lasers(deployment(), std::move(described)), shipped_plugins(), map);
}

std::vector<simulation::Arrival> LiveRobot::later(double by_s) const {
  std::vector<simulation::Arrival> moved = arrivals;
  for (simulation::Arrival& arrival : moved) {
    arrival.at_s += by_s;
    if (auto* odometry = std::get_if<OdometryRecord>(&arrival.record)) odometry->stamp_s += by_s;
    if (auto* scan = std::get_if<RawScan>(&arrival.record)) scan->stamp_s += by_s;
  }
  return moved;
}

Pose2 LiveRobot::truth_at(double stamp_s) const {
  const auto& scans = recording.scans;
  const auto after = std::lower_bound(scans.begin() + 1, scans.end() - 1, stamp_s,
                                      [](const auto& scan, double stamp) { return scan.scan.stamp_s < stamp; });
  const auto& before = *std::prev(after);
  const double share = (stamp_s - before.scan.stamp_s) / (after->scan.stamp_s - before.scan.stamp_s);
  return interpolated(before.T_map_base, after->T_map_base, share);
}
