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

/// How far off odometry may be in position after a step [m]: wheels that slip or are not as large as said lose a share
/// of what was driven. Even after a short step the stamps of odometry and scan differ.
inline double odometry_error_m(double step_m) {
  constexpr double kDrift = 0.15, kLeast_m = 0.1;
  return kLeast_m + kDrift * step_m;
}

/// The time of the search grows with the third power of the window.
inline constexpr double kWidestWindow_m = 0.5, kWidestWindow_rad = 0.35;

/// How far off odometry may be after a step, in position [m] and heading [rad], as far as a search affords it.
inline Eigen::Vector2d odometry_window(double step_m, double turn_rad) {
  constexpr double kTurnDrift = 0.1, kDrift_rad_per_m = 0.08;  // heading is lost by driving, too
  constexpr double kLeast_rad = 0.04;
  return {std::min(kWidestWindow_m, odometry_error_m(step_m)),
          std::min(kWidestWindow_rad, kLeast_rad + kTurnDrift * turn_rad + kDrift_rad_per_m * step_m)};
}

/// How much a residual counts that may be an outlier: 1 at 0, a quarter at `scale` (Geman and McClure 1985).
inline double robust_weight(double error, double scale) {
  const double w = 1 / (1 + error * error / (scale * scale));
  return w * w;
}

}  // namespace opal
