#pragma once

#include <vector>

namespace opal {

/// Numbers of a grid, row by row, smoothed by a Gaussian; beyond the edges lies 0.
/// @param sigma_cells  one standard deviation; less than a tenth of a cell: nothing is done.
void smooth_grid(std::vector<double>& values, int columns, int rows, double sigma_cells);

}  // namespace opal
