#pragma once

#include <opal/common/geometry.hpp>

namespace opal {

/// How far a pose may be off the truth, in position and in heading, and still be right.
struct PoseTolerance {
  double position_m = 1.0;
  double heading_rad = radians(10);

  /// Both errors are below their limits. @param said, truth  in the same frame.
  bool holds(const Pose2& said, const Pose2& truth) const {
    return holds(distance_m(said, truth), angle_between_rad(said, truth));
  }
  bool holds(double error_m, double error_rad) const { return error_m < position_m && error_rad < heading_rad; }
};

/// Every success, false positive and summary judges a pose by this.
inline constexpr PoseTolerance kRightPose{};
/// What is called "strict".
inline constexpr PoseTolerance kStrictlyRightPose{0.5, radians(5)};

}  // namespace opal
