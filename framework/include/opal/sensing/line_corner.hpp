#pragma once

#include <opal/sensing/line_extraction.hpp>

namespace opal {

/// A corner where two faces meet: the intersection of their lines, heading along the bisector of the angle
/// that is open to view. Both lines count as independent in the covariance (x, y, heading).
struct LineCorner {
  OrientedPoint geometry;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

OPAL_EXPORT LineCorner corner_at(const Junction& junction, std::span<const Line> lines);

}  // namespace opal
