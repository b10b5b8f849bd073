#pragma once

#include "simulation/buildings/building.hpp"
#include "simulation/drives/faults.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace opal::experiments {

/// How the robot's map differs from the building.
enum class MapState {
  sound,    ///< not at all
  plan,     ///< it holds long walls only
  damaged,  ///< walls are missing, are elsewhere, or were never built
  redrawn,  ///< another team drew it: wide beams, poses that drift, coarse cells
  learned   ///< damaged, and mended by what drives have taught
};
inline constexpr std::array kMapStates{MapState::sound, MapState::plan, MapState::damaged, MapState::redrawn,
                                       MapState::learned};
const char* name_of(MapState state);

/// One drive of an integrity campaign: all that decides what happens in it. The same values give the same drive.
struct DrawnDrive {
  std::size_t number = 0;                ///< in the campaign, from 0 on
  std::string building_id;               ///< as building_suite() names it
  simulation::BuildingRequest building;  ///< of its ground floor
  int storeys = 1;                       ///< more: the robot is on one of them, and is not told on which
  int storey = 0;                        ///< on which it drives
  MapState map_state = MapState::sound;
  double damage = 0;  ///< share of the mixed damage of docs/results.md; of damaged and learned maps
  bool has_two_lasers = false;
  double clutter = 1, along_walls = 0;  ///< ClutterOptions::level, ::along_walls
  int people = 0;
  double doors_open_share = 0.7;
  bool is_kidnapped = false;                          ///< in the middle of the drive; never together with a fault
  simulation::Fault fault = simulation::Fault::none;  ///< for 10 s in the middle of the drive
  double duration_s = 60;
  std::uint64_t seed = 0;  ///< of everything else
};

/// What happens in the middle of the drive: "none", "kidnapped", or the name of a fault.
std::string event_of(const DrawnDrive& drive);
/// When it begins, and when it ends.
simulation::FaultWindow event_window(const DrawnDrive& drive);

/// The document from which one drive is repeated, and back.
/// @throws ConfigError naming file, place, what was found and what was expected.
nlohmann::ordered_json to_json(const DrawnDrive& drive);
DrawnDrive drawn_drive_from(const nlohmann::json& document, const std::string& file);

}  // namespace opal::experiments
