#pragma once

#include <opal/common/geometry.hpp>

#include <Eigen/Core>

#include <algorithm>

namespace opal {

/// From one pose to another as small changes of (x [m], y [m], heading [rad]) in the frame of both.
inline Eigen::Vector3d step_between(const Pose2& from, const Pose2& to) {
  return {to.x() - from.x(), to.y() - from.y(), wrap_angle(to.heading_rad() - from.heading_rad())};
}

inline Pose2 stepped(const Pose2& pose, const Eigen::Vector3d& step) {
  return {Point(pose.position() + step.head<2>()), pose.heading_rad() + step.z()};
}

/// How far off odometry may be after a step, in position [m] and heading [rad].
inline Eigen::Vector2d odometry_window(double step_m, double turn_rad) {
  return {std::min(0.5, 0.1 + 0.15 * step_m), std::min(0.35, 0.04 + 0.1 * turn_rad + 0.08 * step_m)};
}

/// How much a residual counts that may be an outlier: 1 at 0, a quarter at `scale` (Geman and McClure 1985).
inline double robust_weight(double error, double scale) {
  const double w = 1 / (1 + error * error / (scale * scale));
  return w * w;
}

}  // namespace opal
