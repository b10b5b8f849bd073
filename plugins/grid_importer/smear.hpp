#pragma once

#include "grid.hpp"

namespace opal::grid_importer {

/// Old SLAM maps with large cells, and drawn plans, show walls thicker than they are: faces stand too far out, by half
/// of the smear on each side.

/// Makes a grid worse in this way: occupied cells grow by half of smear_m to all sides, and cells become 0.1 m, each
/// occupied if any cell in it was. Cells that are larger already stay as large.
OccupancyGrid smeared(const OccupancyGrid& grid, double smear_m);

/// How much thicker than they are strokes of occupied cells stand [m], from the thinnest quarter of them: interior
/// walls and the outlines that beams leave are one or two cells wide in a clean grid. 0 if it is no more than noise.
double estimate_smear_m(const OccupancyGrid& grid);

/// Takes the smear off: occupied cells within half of smear_m of others become what is nearest to them, but no stroke
/// loses its middle.
OccupancyGrid unsmeared(const OccupancyGrid& grid, double smear_m);

}  // namespace opal::grid_importer
