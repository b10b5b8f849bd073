#pragma once

#include "map_tools/map_raster.hpp"

#include <vector>

namespace opal {

/// Which cells of a map's raster lie outside the building, by cell: those that a way in the open leads to from the
/// raster's rim. All doors are closed, and what no sensor perceives, as glass, is a wall. A place is in the open if a
/// third of all directions meet nothing that is mapped: so a hall whose gate is missing on the map is inside, but for a
/// strip at the gate. A recess in the open that is hardly deeper than its mouth is wide, as a porch, is outside, too,
/// unless it is a fifth of the building. If less than a third of the free cells were left inside, walls enclose
/// nothing: then what lies beyond the convex hull of everything mapped is outside. Each sheet of a map with storeys
/// counts by itself, and all between sheets is outside.
OPAL_EXPORT std::vector<char> outside_cells(const SemanticMap& map, const MapRaster& raster);

}  // namespace opal
