#pragma once

#include <opal/sensing/sample.hpp>

#include <cmath>

namespace opal {

/// Whether odometry and stamp of a sample are numbers, and within the world. Odometry is added up: one bad reading
/// would spoil all later ones.
inline bool tells_motion(const Sample& sample) {
  constexpr double kFarthest_m = 1e7;
  const Pose2& at = sample.T_odom_base;
  return at.position().allFinite() && at.position().cwiseAbs().maxCoeff() < kFarthest_m &&
         std::isfinite(at.heading_rad()) && std::isfinite(sample.stamp_s);
}

}  // namespace opal
