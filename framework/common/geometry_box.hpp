#pragma once

#include <opal/common/geometry.hpp>

#include <Eigen/Geometry>

namespace opal {

/// The smallest rectangle along the axes of its frame that holds a geometry.
inline Eigen::AlignedBox2d box_of(const Geometry& geometry) {
  if (const auto* segment = std::get_if<Segment>(&geometry))
    return Eigen::AlignedBox2d(segment->begin).extend(segment->end);
  const auto* circle = std::get_if<Circle>(&geometry);
  const Point middle = anchor_of(geometry), margin = Point::Constant(circle ? circle->radius_m : 0);
  return {middle - margin, middle + margin};
}

}  // namespace opal
