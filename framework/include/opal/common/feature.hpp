#pragma once

#include <opal/common/geometry.hpp>

#include <array>
#include <string>

namespace opal {

/// A detected geometric primitive. The type is an open name that any plugin may invent ("opal:Wall",
/// "acme:DoorPost"); it says which map features this may be. The frame is that of whoever holds the feature.
struct Feature {
  std::string type;   ///< prefixed IRI: "opal:Wall"
  Geometry geometry;  ///< the best estimate of shape and place [m, rad]

  /// Covariance of the estimate, by geometry, in this order and these units:
  ///   Point (x, y) [m]; OrientedPoint (x, y, heading) [m, m, rad]; Circle (x, y, radius) [m];
  ///   Segment (offset along the normal at the midpoint, heading) [m, rad]. Unused rows and columns are zero.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  /// Segments: whether begin and end are where the object ends (true), or where something occludes it or the view
  /// ends (false), which makes the length a lower bound.
  std::array<bool, 2> true_end{false, false};

  /// Segments: how much of the length is covered by measurements [m]; other shapes: 0.
  double support_m = 0;
};

/// The feature moved by a rigid motion, covariance included.
OPAL_EXPORT Feature transformed(const Pose2& T_a_b, const Feature& feature_b);

}  // namespace opal
