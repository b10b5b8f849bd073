#pragma once

#include <opal/common/geometry.hpp>

namespace opal {

/// How near two poses are that count as one: one place, or an answer and the truth.
struct PoseTolerance {
  double position_m;   ///< they are nearer than this,
  double heading_rad;  ///< and turned by less than this

  /// @param a, b  in the same frame.
  bool holds(const Pose2& a, const Pose2& b) const {
    return distance_m(a, b) < position_m && angle_between_rad(a, b) < heading_rad;
  }
  bool holds(double apart_m, double apart_rad) const { return apart_m < position_m && apart_rad < heading_rad; }
};

/// To the last bit.
inline bool is_same_pose(const Pose2& a, const Pose2& b) {
  return a.position() == b.position() && a.heading_rad() == b.heading_rad();
}

}  // namespace opal
