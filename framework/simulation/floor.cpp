#include "simulation/floor.hpp"

#include <opal/common/error.hpp>

namespace opal::simulation {

Floor::Floor(const SemanticMap& map, const BuildingGround& ground, const RayCaster& solids, double radius_m)
    : FloorGrid(ground.floor([&](const Point& p) { return !solids.touches(p, radius_m); })) {
  if (cells().empty())
    throw MapError(map.name() + ": has no floor for a robot of " + std::to_string(radius_m) +
                   " m radius, expected a place inside from which mapped walls are seen");
}

}  // namespace opal::simulation
