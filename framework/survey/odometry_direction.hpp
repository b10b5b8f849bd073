#pragma once

#include <opal/common/geometry.hpp>

namespace opal {

/// Odometry whose direction is watched. Some recorded robots count wheel turns without their sign: they back up, and
/// the odometry says that they drive on. When what was found contradicts the odometry's direction, the next motions are
/// taken backwards until it is contradicted again.
class OdometryDirection {
 public:
  /// Odometry as it should be, up to a reading; a frame of its own.
  Pose2 corrected(const Pose2& T_odom_base) const {
    const Pose2 motion = T_odom_before_.inverse() * T_odom_base;
    const Point step = backwards_ ? Point(-motion.position()) : motion.position();
    return T_corrected_before_ * Pose2(step, motion.heading_rad());
  }

  void start(const Pose2& T_odom_base) {
    *this = OdometryDirection();
    T_odom_before_ = T_odom_base;
  }

  /// The same motion, measured otherwise.
  struct Measured {
    Pose2 motion;
    Eigen::Matrix2d covariance;  ///< of its position, in the frame before
  };

  /// A motion is over. @param matched  as scans tell it, @param found  as the map tells it: both have to contradict.
  void advance(const Pose2& T_odom_base, const Measured& matched, const Measured& found) {
    constexpr double kLeastStep_m = 0.06;
    const Pose2 T_corrected_now = corrected(T_odom_base);
    const Point said = (T_corrected_before_.inverse() * T_corrected_now).position();
    if (said.norm() > kLeastStep_m && contradicts(matched, said) && contradicts(found, said)) backwards_ = !backwards_;
    T_corrected_before_ = T_corrected_now;
    T_odom_before_ = T_odom_base;
  }

 private:
  /// Motion to the other side, and surely so: along a corridor, neither scans nor map may tell.
  static bool contradicts(const Measured& measured, const Point& said) {
    constexpr double kOpposite = -0.5, kSigmas = 3;
    const Point direction = said.normalized();
    const double along = measured.motion.position().dot(direction);
    const double sigma = std::sqrt(direction.dot(measured.covariance * direction));
    return along < kOpposite * said.norm() && said.norm() - along > kSigmas * sigma;
  }

  Pose2 T_odom_before_, T_corrected_before_;
  bool backwards_ = false;
};

}  // namespace opal
