#include "simulation/drives/challenges.hpp"

namespace opal::simulation {
namespace {

/// A start, and goals to go on to: places all over the empty building, through its doors, and some way from its walls.
std::vector<Point> route_of(const SemanticMap& building, const SimulationOptions& options, int number) {
  constexpr std::size_t kGoals = 12;
  constexpr double kThroughDoors_m = 0.1, kFromWalls_m = 0.5;
  Random open(1), draw(static_cast<std::uint64_t>(1000 + number));
  const RayCaster solids(building_solids(building, 1, open));
  const Floor empty(building, solids, options.robot_radius_m + kThroughDoors_m);
  std::vector<Point> route;
  for (int tries = 0; route.size() < kGoals; ++tries) {
    const Point place = empty.anywhere(draw);
    constexpr int kPatience = 10000;  // then the building is too narrow to keep away from its walls
    if (tries > kPatience || !solids.touches(place, options.robot_radius_m + kFromWalls_m)) route.push_back(place);
  }
  return route;
}

}  // namespace

std::vector<Challenge> thesis3_challenges() {
  ClutterOptions everyday, deliberate;
  deliberate.level = 1.5;
  deliberate.hidden_share = 0.4;
  deliberate.lookalikes = 1;
  std::vector<Challenge> all;
  for (const int route : {1, 3}) all.push_back({"A" + std::to_string(route), route, everyday, 0, 7.5});
  for (int route = 1; route <= 10; ++route)
    all.push_back({"B" + std::to_string(route), route, everyday, 6, std::nullopt});
  for (const int route : {11, 12}) all.push_back({"C" + std::to_string(route), route, deliberate, 6, std::nullopt});
  return all;
}

ChallengeDrive drive(const Challenge& challenge, std::shared_ptr<const SemanticMap> building, SimulationOptions options,
                     double duration_s, std::uint64_t seed) {
  options.clutter = challenge.clutter;
  options.people = challenge.people;
  options.doors_open_share = 1;  // so that every seed starts in the same room
  const std::vector<Point> route = route_of(*building, options, challenge.route);
  Simulation simulation(std::move(building), options, seed);
  DriveOptions drives;
  const Random heading(static_cast<std::uint64_t>(3000 + challenge.route));
  ChallengeDrive driven{record_route(simulation, route, duration_s, drives, heading), std::nullopt};
  if (challenge.region_m) {
    // The robot is told a region that it is in, not that it is in the middle of it.
    Random off(static_cast<std::uint64_t>(2000 + challenge.route));
    const Point start = driven.recording.scans.front().T_map_base.position();
    const double bearing_rad = off.uniform(-std::numbers::pi, std::numbers::pi);
    driven.region = RegionPrior{start + 0.5 * *challenge.region_m * unit_vector(bearing_rad), *challenge.region_m};
  }
  return driven;
}

}  // namespace opal::simulation
