#pragma once

#include "simulation/buildings/building.hpp"
#include "simulation/drives/challenges.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal::simulation {

/// Which buildings to try a localizer in.
struct SuiteRequest {
  int buildings = 100;             ///< in turn of each kind, then of each difficulty, then with the next seed
  std::vector<std::string> kinds;  ///< of building_kinds(), those of which there are many; empty: all of them
  std::vector<double> difficulties{0, 0.25, 0.5, 0.75, 1};
  /// What difficulty decides, held fast, to see which of them it is.
  std::optional<double> symmetry, size_factor, clutter;
};

/// A building of a suite. Difficulty d in [0, 1] makes it more like itself from place to place (symmetry d),
/// larger (4^(d - 1/2) of the usual size) and fuller (clutter 2 d of everyday's); at 1/2 all is as usual.
struct SuiteBuilding {
  std::string id;  ///< KIND-DIFFICULTY IN PERCENT-SEED: "office-75-3"
  double difficulty = 0;
  BuildingRequest request;
  double clutter = 1;  ///< multiplies that of the challenges
};

/// The same request gives the same buildings; one for more buildings begins with them.
/// @throws ConfigError naming what was asked for and what there is: a kind, or a difficulty outside [0, 1].
std::vector<SuiteBuilding> building_suite(const SuiteRequest& request);

/// The thesis' challenges with as much clutter as there is in a building.
std::vector<Challenge> challenges_in(const SuiteBuilding& building);

}  // namespace opal::simulation
