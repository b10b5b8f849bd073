#pragma once

#include <opal/common/geometry.hpp>

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace opal::ifc_importer {

using Box = Eigen::AlignedBox2d;

/// A set of points of the plane [m]: even-odd inside of closed lines, half-planes, and what set operations make of
/// them.
struct Region {
  enum class Kind { nothing, everything, inside, half_plane, unite, intersect, subtract };
  Kind kind = Kind::nothing;
  std::vector<Segment> edges = {};    ///< inside: of closed lines, in any order and direction
  Box box = Box();                    ///< inside: around the edges
  Point point = Point::Zero();        ///< half_plane: on its border
  Point outward = Point::Zero();      ///< half_plane: away from it
  std::vector<Region> operands = {};  ///< subtract: the first without all others

  bool contains(const Point& p) const;
};

Region inside_of(std::vector<Segment> edges);
Region combined(Region::Kind kind, std::vector<Region> operands);

/// A closed line around a part of a region, the region on its left; straight pieces are not divided.
using Loop = std::vector<Point>;

/// The border of a region. What lies nearer than 0.1 mm to each other is one.
std::vector<Loop> border_of(const Region& region);

Region inside_of(const std::vector<Loop>& loops);
double area_m2(const Loop& loop);  ///< negative around a hole
Box box_of(const Loop& loop);
std::vector<Segment> segments_of(const std::vector<Loop>& loops);

/// The circle that a loop's corners lie on, if it is one: at least 16 corners, none far from the next.
std::optional<Circle> circle_of(const Loop& loop);

}  // namespace opal::ifc_importer
