#pragma once

#include <opal/common/geometry.hpp>

#include <optional>
#include <vector>

namespace opal {

/// What a plan shows of a lift's cabin or a stairwell.
struct ShaftExtent {
  Point middle = Point::Zero();  ///< of the smallest upright rectangle around the outline [m]
  double radius_m = 0;           ///< half of the narrower side, 0.5 to 10
};

/// @param outline  corners, in any order. @return none without corners, or if one is not finite.
std::optional<ShaftExtent> shaft_extent(const std::vector<Point>& outline);

}  // namespace opal
