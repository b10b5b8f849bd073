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

/// A step of Gauss-Newton, no longer than the linear model holds.
inline Eigen::Vector3d limited(const Eigen::Vector3d& step) {
  constexpr double kLongest_m = 0.4, kWidest_rad = 0.15;
  const double share = std::min(1.0, kLongest_m / step.head<2>().norm());
  return {share * step.x(), share * step.y(), std::clamp(step.z(), -kWidest_rad, kWidest_rad)};
}

/// How far off odometry may be after a step, in position [m] and heading [rad].
inline Eigen::Vector2d odometry_window(double step_m, double turn_rad) {
  // Wheels that slip or are not as large as said: a share of what was driven and turned, and heading is lost by
  // driving.
  constexpr double kDrift = 0.15, kTurnDrift = 0.1, kDrift_rad_per_m = 0.08;
  // What is wrong even after a short step: the stamps of odometry and scan.
  constexpr double kLeast_m = 0.1, kLeast_rad = 0.04;
  // The time of the search grows with the third power of the window.
  constexpr double kMost_m = 0.5, kMost_rad = 0.35;
  return {std::min(kMost_m, kLeast_m + kDrift * step_m),
          std::min(kMost_rad, kLeast_rad + kTurnDrift * turn_rad + kDrift_rad_per_m * step_m)};
}

/// How much a residual counts that may be an outlier: 1 at 0, a quarter at `scale` (Geman and McClure 1985).
inline double robust_weight(double error, double scale) {
  const double w = 1 / (1 + error * error / (scale * scale));
  return w * w;
}

}  // namespace opal
