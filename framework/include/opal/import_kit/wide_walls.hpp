#pragma once

#include <opal/common/geometry.hpp>

#include <vector>

namespace opal {

/// A straight piece of a wall that was drawn by its middle. In the `map` frame.
struct WidePiece {
  Segment middle;      ///< from end to end
  double width_m = 0;  ///< thickness of the wall
};

/// The outline of each piece, four points counterclockwise. Where two pieces meet, both end on the line that halves
/// their angle; where more meet, each goes on by half of its width.
std::vector<std::vector<Point>> widened(const std::vector<WidePiece>& pieces);

}  // namespace opal
