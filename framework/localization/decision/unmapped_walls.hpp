#pragma once

#include <opal/local_map/local_map.hpp>
#include <opal/map/view/map_view.hpp>

namespace opal {

/// Length [m] of the walls in a local map, stable and straight, that have no mapped surface beside them. Furniture and
/// people are not walls: what is shorter than 2.5 m does not count. Many metres of it say that the map lacks walls
/// here, or that the robot is elsewhere.
OPAL_EXPORT double unmapped_walls_m(const LocalMap& local_map, const MapView& map, const Pose2& T_map_local);

}  // namespace opal
