#pragma once

#include "common/random.hpp"
#include "simulation/ray_caster.hpp"

#include <opal/map/semantic_map.hpp>
#include "map_tools/floor_grid.hpp"

namespace opal::simulation {

/// Where in a building one can be: cells of 0.1 m from which some mapped surface is seen on its visible side, less
/// those too near to something solid. Frame: `map`.
class Floor : public FloorGrid {
 public:
  /// @param radius_m  of whoever wants to be there.
  /// @throws MapError if there is no such place.
  Floor(const SemanticMap& map, const RayCaster& solids, double radius_m)
      : Floor(map, floor_raster(map), solids, radius_m) {}
  /// @param seen  floor_raster() of the map.
  Floor(const SemanticMap& map, const MapRaster& seen, const RayCaster& solids, double radius_m);

  /// Some place on it.
  Point anywhere(Random& random) const { return center_of(cells()[random.below(cells().size())]); }
};

}  // namespace opal::simulation
