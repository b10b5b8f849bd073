#pragma once

#include <opal/common/export.hpp>
#include <opal/common/geometry.hpp>

namespace opal {

/// What the odometry of one robot has to be multiplied by; `opal calibrate` finds it.
struct OdometryScale {
  double distance = 1;  ///< metres driven per metre of odometry
  double turn = 1;      ///< radians turned per radian of odometry
};

/// Odometry whose steps are scaled. Frame `odom` begins where the recorded one does.
class OPAL_EXPORT ScaledOdometry {
 public:
  /// Odometry that passes through unchanged if both scales are 1.
  explicit ScaledOdometry(const OdometryScale& scale = {}) : scale_(scale) {}

  /// Takes the next reading. @return its pose, scaled since the first reading.
  Pose2 next(const Pose2& T_odom_base);
  /// The pose that a later reading would have, without taking it.
  Pose2 at(const Pose2& T_odom_base) const;

 private:
  OdometryScale scale_;
  bool begun_ = false;
  Pose2 T_recorded_, T_scaled_;
};

}  // namespace opal
