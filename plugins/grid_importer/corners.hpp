#pragma once

#include "face.hpp"
#include "grid.hpp"
#include "grid_kind.hpp"

#include <vector>

namespace opal::grid_importer {

/// Where one face ends and the next begins, going along a surface with free space on the left.
struct Corner {
  CellPoint position = CellPoint::Zero();
  int before = 0;  ///< number of the face that ends here
  int after = 0;   ///< number of the face that begins here
};

/// Finds faces whose ends meet at an angle, and moves these ends to the intersection of their lines. Every end is
/// part of one corner at most; the nearest pairs come first. No face is drawn out through space that beams crossed.
/// @param kind  of a drawn plan short faces are as straight as long ones, and have corners, too.
std::vector<Corner> join_corners(std::vector<Face>& faces, const OccupancyGrid& grid, GridKind kind);

}  // namespace opal::grid_importer
