#pragma once

#include "dxf_drawing.hpp"

#include <vector>

namespace opal::dxf_importer {

/// A piece of the boundary of a hatch.
struct BoundaryEdge {
  Point from = Point::Zero(), to = Point::Zero();
  double bulge = 0;  ///< as DxfVertex has it, on the way from `from` to `to`
};

/// Puts the edges of each loop one after the other, turned where they are written the other way round. A loop whose
/// edges do not meet encloses nothing (CAD programs keep such loops): it goes, and is counted.
/// @param edges  of the loops of `fill`; none: that loop has its vertices already.
void close_loops(const std::vector<std::vector<BoundaryEdge>>& edges, DxfFill& fill);

}  // namespace opal::dxf_importer
