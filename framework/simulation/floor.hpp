#pragma once

#include "common/random.hpp"
#include "simulation/ray_caster.hpp"

#include <opal/map/semantic_map.hpp>
#include "map_tools/building_ground.hpp"

namespace opal::simulation {

/// Where in a building one can be: ground of the building (BuildingGround), less what is too near to something solid.
/// Frame: `map`.
class Floor : public FloorGrid {
 public:
  /// @param radius_m  of whoever wants to be there.
  /// @throws MapError if there is no such place.
  Floor(const SemanticMap& map, const RayCaster& solids, double radius_m)
      : Floor(map, BuildingGround(map), solids, radius_m) {}
  /// @param ground  of the map.
  Floor(const SemanticMap& map, const BuildingGround& ground, const RayCaster& solids, double radius_m);

  /// Some place on it.
  Point anywhere(Random& random) const { return center_of(cells()[random.below(cells().size())]); }
};

}  // namespace opal::simulation
