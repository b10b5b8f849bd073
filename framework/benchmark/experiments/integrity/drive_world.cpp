#include "benchmark/experiments/integrity/drive_world.hpp"

#include "map_tools/map_stack.hpp"
#include "map_tools/test_maps/map_damage.hpp"

namespace opal::experiments {
namespace {

constexpr double kLaserScanEvery_s = 0.1;

std::string storey_id(int storey) { return "level-" + std::to_string(storey); }

/// Somebody has rebuilt a floor here and there: most of it looks as before.
std::shared_ptr<const SemanticMap> rebuilt(const SemanticMap& floor, std::uint64_t seed) {
  MapDamage changes;
  changes.drop = 0.05;
  changes.wall_m = 0.6;
  changes.wall_share = 0.15;
  changes.seed = seed;
  return damaged_map(floor, changes);
}

/// All storeys, each on a sheet of its own. In buildings that repeat themselves, floors do, too.
std::shared_ptr<const SemanticMap> whole_building(const DrawnDrive& drive) {
  const auto ground = generate_building(drive.building).map;
  if (drive.storeys == 1) return ground;
  constexpr double kAlike = 0.5;
  std::vector<StoreyPart> parts;
  for (int k = 0; k < drive.storeys; ++k) {
    simulation::BuildingRequest other = drive.building;
    other.seed += 1'000'003 * static_cast<std::uint64_t>(k);
    const bool is_rebuilt = k > 0 && drive.building.symmetry >= kAlike;
    const auto floor = is_rebuilt ? rebuilt(*ground, other.seed) : generate_building(other).map;
    parts.push_back({storey_id(k), "Level " + std::to_string(k), {}, floor});
  }
  return stacked_map(drive.building_id, parts).map;
}

MapDamage damage_of(const DrawnDrive& drive) {
  MapDamage damage;
  if (drive.map_state == MapState::plan) damage.plan_m = 1.5;
  if (drive.map_state == MapState::damaged || drive.map_state == MapState::learned) {
    damage.drop = 0.3 * drive.damage;
    damage.shift_m = 0.1 * drive.damage;
    damage.wall_m = 0.6 * drive.damage;
    damage.false_share = drive.storeys == 1 ? 0.3 * drive.damage : 0;  // some would stand between the storeys' sheets
  }
  damage.seed = drive.seed;
  return damage;
}

simulation::SimulationOptions options_of(const DrawnDrive& drive, const Deployment& robot) {
  simulation::SimulationOptions options;
  options.take(robot.lasers);
  options.clutter.level = drive.clutter;
  options.clutter.along_walls = drive.along_walls;
  options.people = drive.people;
  options.doors_open_share = drive.doors_open_share;
  return options;
}

void append(simulation::Recording& recording, simulation::Recording more) {
  const auto move = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move(recording.scans, more.scans);
  move(recording.more_scans, more.more_scans);
  move(recording.odometry, more.odometry);
}

}  // namespace

DriveWorld world_of(const DrawnDrive& drive, const CampaignRobots& robots, const std::filesystem::path& scratch) {
  const auto building = whole_building(drive);
  DriveWorld world{drive.storeys > 1 ? storey_of_map(*building, storey_id(drive.storey)) : building, building};
  if (drive.map_state == MapState::redrawn) world.map = redrawn_map(building, drive, robots, scratch);
  if (drive.map_state == MapState::redrawn || drive.map_state == MapState::sound) return world;
  world.map = damaged_map(*building, damage_of(drive));
  if (drive.map_state == MapState::learned) world.map = learned_map(building, world.map, drive, robots);
  return world;
}

simulation::Recording recorded(const DrawnDrive& drive, const DriveWorld& world, const Deployment& robot) {
  Random random(drive.seed);
  simulation::Simulation simulation(world.building, options_of(drive, robot), drive.seed);
  const double first_s = drive.is_kidnapped ? event_window(drive).from_s : drive.duration_s;
  simulation::DriveOptions options;
  options.scan_every_s = kLaserScanEvery_s;
  simulation::Recording recording = record_about(simulation, first_s, options, random.branch());
  if (drive.is_kidnapped)
    append(recording, record_about(simulation, drive.duration_s - first_s, options, random.branch()));
  return recording;
}

}  // namespace opal::experiments
