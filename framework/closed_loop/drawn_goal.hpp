#pragma once

#include "map_tools/floor_grid.hpp"
#include "simulation/simulation.hpp"

#include <optional>

namespace opal {

/// A goal for a robot where it stands: a free place to which a way leads by the map, and in a large building one that
/// is not near. None if many draws find no such place.
/// @param floor  by which the robot plans.
std::optional<Point> drawn_goal(const simulation::Simulation& simulation, const FloorGrid& floor, Random& random);

}  // namespace opal
