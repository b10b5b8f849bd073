#pragma once

#include <opal/common/geometry.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace opal {

/// Neighbouring points of a scan that belong together.
struct PointRun {
  std::size_t first = 0;  ///< position among the points
  std::size_t end = 0;    ///< one past the last
  bool may_walk = false;  ///< it is no wider than a person: legs, a bag, a piece of a wall between two posts
};

/// Cuts points where one is far from the next: whatever stands free of its surroundings is a run of its own.
/// @param points  as seen from the origin [m], by increasing bearing, finite.
/// @return in their order; together all points.
OPAL_EXPORT std::vector<PointRun> point_runs(std::span<const Point> points);

}  // namespace opal
