#pragma once

#include <opal/common/geometry.hpp>

#include <string>

namespace opal {

/// The origin that a map gets of a plan in a national grid (UTM), which lies beyond 1e6 m from 0: the lower left corner
/// of the plan's bounds, rounded down to 1 km, so that the storeys of a building have the same one. Zero if the plan
/// lies nearer, or is itself no building.
/// @param low_m, high_m  bounds of the plan [m], in its own frame.
Point origin_of_far_plan(const Point& low_m, const Point& high_m);

/// About such an origin, with the options of importers that set it.
std::string sentence_about_far_origin(const Point& origin_m);

}  // namespace opal
