#pragma once

#include "boundary.hpp"
#include "vectorizer_limits.hpp"

#include <vector>

namespace opal::grid_importer {

/// A round column standing alone. In cell units.
struct RoundColumn {
  CellPoint centre = CellPoint::Zero();
  double radius = 0;
  double rms = 0;  ///< root mean square distance of its boundary cells to the circle
};

/// Finds isolated blobs that a circle describes better than a box does, and marks their cells as explained.
std::vector<RoundColumn> find_round_columns(Boundary& boundary, const VectorizerLimits& limits);

}  // namespace opal::grid_importer
