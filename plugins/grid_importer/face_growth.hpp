#pragma once

#include "boundary.hpp"
#include "face.hpp"
#include "vectorizer_limits.hpp"

#include <vector>

namespace opal::grid_importer {

/// Finds faces by growing lines from the straightest places, longest first, over gaps and through noise, each side
/// of a wall for itself. Marks what they explain in `boundary`.
std::vector<Face> grow_faces(Boundary& boundary, const VectorizerLimits& limits);

}  // namespace opal::grid_importer
