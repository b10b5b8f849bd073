#pragma once

#include "common/pose_tolerance.hpp"

#include <cmath>

namespace opal {

/// Two readings of odometry between which nothing was counted.
inline constexpr PoseTolerance kNothingCounted{0.005, 0.005};

/// No motion worth the name, by odometry or by scans.
inline bool is_standstill(const Pose2& motion) {
  constexpr PoseTolerance kStands{0.02, 0.02};
  return kStands.holds(motion.position().norm(), std::abs(motion.heading_rad()));
}

}  // namespace opal
