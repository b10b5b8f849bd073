#include "ros2/odometry/odometry_comparison.hpp"

#include <fmt/format.h>

#include <cmath>

namespace opal::ros2 {
namespace {

// Two messages of 10 Hz lie so near to each other.
constexpr double kSameTimeS = 0.06;
// A robot of 2 m/s drives 0.12 m in that time, and one of 2 rad/s turns 0.12 rad.
constexpr double kSameM = 0.2, kSameRad = 0.2;

}  // namespace

void OdometryComparison::hear_transform(const OdometryRecord& odometry) {
  if (!message_ || !(std::abs(odometry.stamp_s - message_->stamp_s) < kSameTimeS)) return;
  const double apart_m = distance_m(odometry.T_odom_base, message_->T_odom_base);
  const double apart_rad = std::abs(angle_between_rad(odometry.T_odom_base, message_->T_odom_base));
  const bool is_same = apart_m < kSameM && apart_rad < kSameRad;
  difference_ = is_same ? "" : fmt::format("{:.2f} m and {:.2f} rad", apart_m, apart_rad);
}

}  // namespace opal::ros2
