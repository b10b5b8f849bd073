#pragma once

#include <opal/sensing/lines/line_extraction.hpp>

namespace opal {

/// A corner where two faces meet: the intersection of their lines, heading along the bisector of the angle
/// that is open to view. Both lines count as independent in the covariance (x, y, heading).
struct LineCorner {
  OrientedPoint geometry;                                ///< sensor frame
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, heading) [m, m, rad]
};

/// The corner at a junction of two of these lines, which are those that the junction was found in.
OPAL_EXPORT LineCorner corner_at(const Junction& junction, std::span<const Line> lines);

}  // namespace opal
