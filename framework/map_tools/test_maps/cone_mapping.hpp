#pragma once

#include "map_tools/map_raster.hpp"

#include <opal/sensing/scan.hpp>

#include <cstdint>
#include <vector>

namespace opal {

/// A scan whose place is known.
struct PlacedScan {
  Scan scan;
  Pose2 T_map_laser;
};

/// How another team draws a building: with sensors of wide beams, at poses that drift.
struct ConeMapping {
  double cone_rad = 0.2618;    ///< opening of a beam; 15 degrees, as of a sonar
  double range_sigma_m = 0.1;  ///< of a range
  double reach_m = 8;          ///< a beam that meets nothing within it is free
  double drift_m = 0.1;        ///< one sigma of the poses' error in x and in y, which changes along tens of metres
  double drift_rad = 0.02;     ///< the same for the heading
  double resolution_m = 0.1;   ///< side of a cell
  double blur_m = 0.1;         ///< one sigma of the Gaussian that smooths the map; 0: none
  std::uint64_t seed = 1;      ///< the same seed gives the same map
};

/// An occupancy grid as such a team draws it: each beam takes the nearest return within its cone, and marks the whole
/// arc at that range as occupied. So walls become thick, and bulge into rooms where they are seen at an angle.
/// Evidence grids: Moravec and Elfes 1985; log odds: Elfes 1989.
/// @param scans  in the order of the drive. @throws ConfigError if a number makes no sense, or there is no scan.
OPAL_EXPORT MapRaster cone_mapped(const std::vector<PlacedScan>& scans, const ConeMapping& mapping);

}  // namespace opal
