#pragma once

#include "common/random.hpp"

#include "common/velocity.hpp"

namespace opal::simulation {

enum class Drive { differential, omnidirectional };

/// What wheel odometry gets wrong. Variances grow with the motion (Thrun, Burgard and Fox 2005, 5.4), biases are those
/// of one robot, slips those of one moment.
struct OdometryErrors {
  double sigma_m_per_sqrt_m = 0.02;     ///< along the way
  double sideways_m_per_sqrt_m = 0.01;  ///< across it; twice as much for an omnidirectional drive
  double sigma_rad_per_sqrt_m = 0.01;
  double sigma_rad_per_sqrt_rad = 0.03;
  double scale_bias = 0.01;            ///< one-sigma of a robot's error in wheel radius
  double turn_bias_rad_per_m = 0.003;  ///< one-sigma of a robot's pull to one side
  double slips_per_m = 0.02;
  double slip_m = 0.1;  ///< one-sigma of what a slip adds or takes
  double slip_rad = 0.05;
};

/// Wheel odometry of one robot: frame `odom` begins where it is switched on.
class WheelOdometry {
 public:
  WheelOdometry(Drive drive, const OdometryErrors& errors, Random random);
  /// @param T_before_after  the true motion.
  void move(const Pose2& T_before_after);
  const Pose2& T_odom_base() const { return T_odom_base_; }

 private:
  Drive drive_;
  OdometryErrors errors_;
  Random random_;
  double scale_, turn_per_m_;
  Pose2 T_odom_base_;
};

}  // namespace opal::simulation
