#include "simulation/drives/storey_drives.hpp"

#include "map_tools/map_stack.hpp"

#include <opal/common/error.hpp>

#include <algorithm>

namespace opal::simulation {
namespace {

/// One robot records first `all`, then `more`, whose clock and odometry began anew.
void append(Recording& all, Recording more, double later_s, const Pose2& T_odom_odom) {
  for (RecordedScan& recorded : more.scans) {
    carry_on(recorded.scan, later_s, T_odom_odom);
    all.scans.push_back(std::move(recorded));
  }
  for (RawScan& scan : more.more_scans) {
    carry_on(scan, later_s, T_odom_odom);
    all.more_scans.push_back(std::move(scan));
  }
  for (OdometryRecord& odometry : more.odometry) {
    odometry.stamp_s += later_s;
    odometry.T_odom_base = T_odom_odom * odometry.T_odom_base;
    all.odometry.push_back(odometry);
  }
  for (const Query& query : more.queries)
    all.queries.push_back(
        {query_name(static_cast<int>(all.queries.size()) + 1), query.start_s + later_s, query.end_s + later_s});
  all.distances_m.insert(all.distances_m.end(), more.distances_m.begin(), more.distances_m.end());
  all.stops += more.stops;
}

}  // namespace

Recording record_on_storeys(const SemanticMap& building, const SimulationOptions& world, const DriveOptions& drives,
                            std::uint64_t seed) {
  const std::vector<MapStorey>& storeys = building.origin().storeys;
  if (storeys.empty()) throw ConfigError(building.name() + ": holds no storeys, expected some");
  Recording all;
  all.laser = world.laser;
  all.more_lasers = world.more_lasers;
  double later_s = 0;
  Pose2 T_odom_end;
  for (int k = 0; k < drives.drives; ++k) {
    const MapStorey& storey = storeys[static_cast<std::size_t>(k) % storeys.size()];
    const std::uint64_t own_seed = seed * 1000003 + static_cast<std::uint64_t>(k);
    Simulation simulation(storey_of_map(building, storey.id), world, own_seed);
    DriveOptions one = drives;
    one.drives = 1;
    const Pose2 T_odom_odom = T_odom_end * simulation.T_odom_base().inverse();
    append(all, record(simulation, one, Random(own_seed).branch()), later_s, T_odom_odom);
    later_s += simulation.now_s();
    T_odom_end = T_odom_odom * simulation.T_odom_base();
  }
  return all;
}

}  // namespace opal::simulation
