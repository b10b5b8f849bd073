#pragma once

#include "simulation/buildings/floor_plan.hpp"

#include <opal/map/semantic_map.hpp>

#include <memory>
#include <string>

namespace opal::simulation {

/// The semantic map of a floor plan. Faces look onto the floor, and those that meet share a point; where they turn
/// there is a corner. Walls are objects room by room; what is small and convex all around is a column, round or not.
/// Leaves and panes are there, perceived by no sensor; corners with them are not.
std::shared_ptr<const SemanticMap> map_of(const std::string& name, const FloorPlan& plan);

}  // namespace opal::simulation
