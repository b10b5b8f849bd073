#pragma once

#include "columns.hpp"
#include "corners.hpp"
#include "face.hpp"
#include "grid_kind.hpp"

#include <vector>

namespace opal::grid_importer {

/// What a grid looks like to a planar LiDAR. In cell units.
struct VectorMap {
  std::vector<Face> faces;
  std::vector<Corner> corners;  ///< of `faces`, by number
  std::vector<RoundColumn> columns;
  int drawn_faces = 0;  ///< so many of `faces`, the first ones, run along rows and columns as they were drawn
};

VectorMap vectorize(Boundary& boundary, const VectorizerLimits& limits, GridKind kind);

}  // namespace opal::grid_importer
