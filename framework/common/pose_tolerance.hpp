#pragma once

#include <opal/common/geometry.hpp>

namespace opal {

/// How near to each other two poses are that count as one place.
struct PlaceTolerance {
  double position_m;   ///< they are nearer than this,
  double heading_rad;  ///< and turned by less than this

  bool same(const Pose2& a, const Pose2& b) const {
    return distance_m(a, b) < position_m && angle_between_rad(a, b) < heading_rad;
  }
};

/// To the last bit.
inline bool is_same_pose(const Pose2& a, const Pose2& b) {
  return a.position() == b.position() && a.heading_rad() == b.heading_rad();
}

}  // namespace opal
