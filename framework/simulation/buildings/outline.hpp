#pragma once

#include "simulation/buildings/plan_grid.hpp"

#include <array>
#include <vector>

namespace opal::simulation {

/// A straight piece of the border of the floor, which lies on its left.
struct OutlineFace {
  std::array<int, 2> begin{}, end{};  ///< x, y [cm]
  int quarter = 0;                    ///< its direction: this many quarter turns from the x axis, 0 to 3
  int thing = FloorPlan::kWall;       ///< what it is the surface of
  int space = FloorPlan::kNoSpace;    ///< the room that it borders
  bool is_glass = false;              ///< outdoors behind it

  int length() const { return std::abs(end[0] - begin[0]) + std::abs(end[1] - begin[1]); }
};

/// Faces all around a piece of solid, or around the floor: each begins where the one before ends, the first one where
/// the last one ends. It begins at a corner of its lowest row, so that a plan has one outline only.
using Outline = std::vector<OutlineFace>;

/// All outlines, from the lowest row up and from left to right.
std::vector<Outline> outlines_of(const PlanGrid& grid);

}  // namespace opal::simulation
