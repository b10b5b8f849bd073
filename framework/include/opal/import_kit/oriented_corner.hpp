#pragma once

#include <opal/common/geometry.hpp>

#include <numbers>

namespace opal {

/// The corner between two faces that go along one surface with free space on their left. Open to view is what lies
/// counter-clockwise from the way on, up to the way back.
/// @param before  ends at the corner.
/// @param after   begins there.
inline OrientedPoint oriented_corner(const Segment& before, const Segment& after) {
  const double opening_rad = std::numbers::pi - wrap_angle(after.heading_rad() - before.heading_rad());
  return {after.begin, wrap_angle(after.heading_rad() + opening_rad / 2), opening_rad};
}

}  // namespace opal
