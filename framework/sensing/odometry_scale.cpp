#include <opal/sensing/odometry_scale.hpp>

namespace opal {

Pose2 ScaledOdometry::at(const Pose2& T_odom_base) const {
  if (!begun_ || (scale_.distance == 1 && scale_.turn == 1)) return T_odom_base;
  const Pose2 step = T_recorded_.inverse() * T_odom_base;
  return T_scaled_ * Pose2(scale_.distance * step.position(), scale_.turn * step.heading_rad());
}

Pose2 ScaledOdometry::next(const Pose2& T_odom_base) {
  T_scaled_ = at(T_odom_base);
  T_recorded_ = T_odom_base;
  begun_ = true;
  return T_scaled_;
}

}  // namespace opal
