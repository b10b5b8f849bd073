#pragma once

#include "import_kit/plan_strokes.hpp"

#include <array>
#include <utility>
#include <vector>

namespace opal {

/// Lines that are the two faces of a wall.
struct PlanPairs {
  std::vector<std::array<Point, 4>> walls;  ///< what lies between two edges, as far as they are side by side
  /// Where a wall's other face ends in the middle of an edge: number of the edge and place on it.
  std::vector<std::pair<int, Point>> ends;
};

/// Among the lines whose sides are to be found. Edges that go on straight, or around a smooth bend, count together:
/// side by side over at least their distance, which is at most max_wall_thickness_m. A niche between two thinner walls
/// is none.
PlanPairs find_pairs(const PlanStrokes& strokes, const PlanOptions& options);

}  // namespace opal
