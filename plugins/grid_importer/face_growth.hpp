#pragma once

#include "boundary.hpp"
#include "face.hpp"
#include "grid_kind.hpp"
#include "vectorizer_limits.hpp"

#include <vector>

namespace opal::grid_importer {

/// Finds faces by growing lines from the straightest places, longest first, over gaps and through noise, each side
/// of a wall for itself. Marks what they explain in `boundary`.
/// @param kind  of a drawn plan some faces are found already; their cells may have another side.
std::vector<Face> grow_faces(Boundary& boundary, const VectorizerLimits& limits, GridKind kind);

}  // namespace opal::grid_importer
