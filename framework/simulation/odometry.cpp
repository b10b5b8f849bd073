#include "simulation/odometry.hpp"

namespace opal::simulation {
namespace {

/// Drawn one by one: arguments of one call may be evaluated in any order.
Pose2 anywhere(Random& random) {
  const double heading_rad = random.uniform(-3, 3), y_m = random.uniform(-10, 10), x_m = random.uniform(-10, 10);
  return {x_m, y_m, heading_rad};
}

}  // namespace

WheelOdometry::WheelOdometry(Drive drive, const OdometryErrors& errors, Random random)
    : drive_(drive),
      errors_(errors),
      random_(random),
      scale_(1 + random_.normal(errors.scale_bias)),
      turn_per_m_(random_.normal(errors.turn_bias_rad_per_m)),
      T_odom_base_(anywhere(random_)) {}

void WheelOdometry::move(const Pose2& T_before_after) {
  const double way = T_before_after.position().norm(), turn = std::abs(T_before_after.heading_rad());
  const double root_m = std::sqrt(way), sideways = drive_ == Drive::omnidirectional ? 2 : 1;
  Point step = scale_ * T_before_after.position();
  double heading = T_before_after.heading_rad() + turn_per_m_ * way;
  const Point along = way > 0 ? Point(T_before_after.position() / way) : Point::UnitX();
  step += along * random_.normal(errors_.sigma_m_per_sqrt_m * root_m);
  step += left_of(along) * random_.normal(sideways * errors_.sideways_m_per_sqrt_m * root_m);
  heading += random_.normal(errors_.sigma_rad_per_sqrt_m * root_m + errors_.sigma_rad_per_sqrt_rad * std::sqrt(turn));
  if (random_.chance(errors_.slips_per_m * way)) {
    step += along * random_.normal(errors_.slip_m);
    heading += random_.normal(errors_.slip_rad);
  }
  T_odom_base_ = T_odom_base_ * Pose2(step, heading);
}

}  // namespace opal::simulation
