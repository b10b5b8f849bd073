#pragma once

#include "columns.hpp"
#include "corners.hpp"
#include "face.hpp"

#include <vector>

namespace opal::grid_importer {

/// What a grid looks like to a planar LiDAR. In cell units.
struct VectorMap {
  std::vector<Face> faces;
  std::vector<Corner> corners;  ///< of `faces`, by number
  std::vector<RoundColumn> columns;
  int drawn_faces = 0;  ///< so many of `faces`, the first ones, run along rows and columns as they were drawn
};

/// @param is_drawn  the grid is a plan that was drawn along its rows and columns: `is_drawn_plan`.
VectorMap vectorize(Boundary& boundary, const VectorizerLimits& limits, bool is_drawn);

}  // namespace opal::grid_importer
