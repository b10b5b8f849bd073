#pragma once

#include "common/random.hpp"
#include "simulation/pieces.hpp"

namespace opal::simulation {

/// What stands along the walls of a laboratory, a workshop or a store, and no plan holds: machines, boxes, benches and
/// shelves on legs, bins. A low laser sees them instead of the walls. Each leaves a way of 1.1 m before it, and doors
/// stay free.
/// @param share  of the length of the walls that has something before it, where there is room; 0 to 1.
std::vector<Piece> pieces_along_walls(const SemanticMap& map, double share, Random& random);

}  // namespace opal::simulation
