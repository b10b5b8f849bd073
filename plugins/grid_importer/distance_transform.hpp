#pragma once

#include "grid.hpp"

#include <vector>

namespace opal::grid_importer {

/// For each cell the distance, in cells, from its centre to the nearest centre of a cell that is occupied (or that is
/// not); 0 for these themselves. What is outside of the grid is not occupied. Exact and linear in the number of cells
/// (Felzenszwalb and Huttenlocher 2012, "Distance Transforms of Sampled Functions").
std::vector<float> distance_to_occupied(const OccupancyGrid& grid);
std::vector<float> distance_to_unoccupied(const OccupancyGrid& grid);

}  // namespace opal::grid_importer
