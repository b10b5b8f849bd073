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
};

VectorMap vectorize(Boundary& boundary, const VectorizerLimits& limits);

}  // namespace opal::grid_importer
