#include "simulated_world.hpp"

#include <cmath>

using namespace opal;
using namespace opal::simulation;

namespace {

double rounded(double value, double step) { return step * std::round(value / step); }

}  // namespace

World world_of(const BuildingRequest& building, const std::string& config) {
  World world{generate_building(building).map, config, {}};
  world.options.take(world.deployment().lasers);
  world.options.people = 1;
  return world;
}

Recording driven(const World& world, double duration_s, std::uint64_t seed) {
  Simulation simulation(world.map, world.options, seed);
  DriveOptions drive;
  drive.scan_every_s = 0.1;
  return record_about(simulation, duration_s, drive, Random(seed));
}

Arrivals arrivals_in(const Recording& recording) {
  Arrivals arrivals = arrivals_of(records_of(recording), recording.laser.sweep_s.value_or(0));
  const auto round_pose = [](Pose2& pose) {
    pose = Pose2(rounded(pose.x(), 1e-3), rounded(pose.y(), 1e-3), rounded(pose.heading_rad(), 1e-4));
  };
  for (Arrival& arrival : arrivals) {
    arrival.at_s = rounded(arrival.at_s, 1e-4);
    if (auto* odometry = std::get_if<OdometryRecord>(&arrival.record)) {
      odometry->stamp_s = rounded(odometry->stamp_s, 1e-4);
      round_pose(odometry->T_odom_base);
    }
    if (auto* scan = std::get_if<RawScan>(&arrival.record)) {
      scan->stamp_s = rounded(scan->stamp_s, 1e-4);
      if (scan->T_odom_base) round_pose(*scan->T_odom_base);
      for (float& range_m : scan->ranges_m) range_m = static_cast<float>(rounded(range_m, 1e-3));
    }
  }
  return arrivals;
}

Arrivals arrivals_with(const World& world, double duration_s, const Faults& faults) {
  Arrivals arrivals = arrivals_in(driven(world, duration_s, 5));
  for (const auto& [fault, window] : faults)
    arrivals = with_fault(std::move(arrivals), fault, window, world.deployment().lasers.back().frame, Random(7));
  return arrivals;
}
