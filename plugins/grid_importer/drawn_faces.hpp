#pragma once

#include "boundary.hpp"
#include "face.hpp"
#include "grid_kind.hpp"
#include "vectorizer_limits.hpp"

#include <vector>

namespace opal::grid_importer {

/// A grid is a plan that was drawn if much of what is seen in it runs straight to the cell, as in no recorded grid.
GridKind kind_of(const Boundary& boundary);

/// The faces of such a plan along its rows and columns. They come in as drawn, with jogs and niches that a line with a
/// tolerance would run across. Their cells become explained.
std::vector<Face> find_drawn_faces(Boundary& boundary, const VectorizerLimits& limits);

}  // namespace opal::grid_importer
