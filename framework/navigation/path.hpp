#pragma once

#include <opal/common/geometry.hpp>

#include <limits>
#include <span>

namespace opal::navigation {

/// A place on a path of straight pieces, next to some other place.
struct PlaceOnPath {
  std::size_t piece = 0;  ///< begins at this point of the path
  Point position = Point::Zero();
  double along_m = 0;                                      ///< from the first piece that was looked at
  double off_m = std::numeric_limits<double>::infinity();  ///< from the other place
};

/// The place on a path that is nearest to p, on piece `first` or later, no farther along than `most_m` where pieces
/// end.
/// @param path  not empty; a single point is a path, too.
PlaceOnPath nearest_on_path(std::span<const Point> path, const Point& p, std::size_t first = 0,
                            double most_m = std::numeric_limits<double>::infinity());
/// The place so far along a path; its end if it is shorter.
Point point_along(std::span<const Point> path, double along_m);
double length_m(std::span<const Point> path);

}  // namespace opal::navigation
