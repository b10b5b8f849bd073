#include "simulation/floor.hpp"

#include <opal/common/error.hpp>

namespace opal::simulation {

Floor::Floor(const SemanticMap& map, const MapRaster& seen, const RayCaster& solids, double radius_m)
    : FloorGrid(seen_floor(seen, [&](const Point& p) { return !solids.touches(p, radius_m); })) {
  if (cells().empty())
    throw MapError(map.name() + ": has no floor for a robot of " + std::to_string(radius_m) +
                   " m radius, expected a place from which mapped walls are seen");
}

}  // namespace opal::simulation
