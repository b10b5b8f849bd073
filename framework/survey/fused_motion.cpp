#include "survey/fused_motion.hpp"

#include "localization/alignment/pose_step.hpp"

#include <Eigen/Dense>

namespace opal {

Eigen::Matrix3d turned(const Eigen::Matrix3d& covariance, const Pose2& T_to_from) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.col(0).head<2>() = T_to_from.rotate(Point::UnitX());
  R.col(1).head<2>() = T_to_from.rotate(Point::UnitY());
  return R * covariance * R.transpose();
}

Motion fused(const Motion& a, const Motion& b) {
  constexpr double kContradiction = 2.5 * 2.5;
  const Eigen::Matrix3d information = (a.covariance + b.covariance).inverse();
  const Eigen::Matrix3d gain = a.covariance * information;
  const Eigen::Vector3d apart = step_between(a.T_before_now, b.T_before_now);
  if (apart.dot(information * apart) > kContradiction) return b;
  return {stepped(a.T_before_now, gain * apart), (Eigen::Matrix3d::Identity() - gain) * a.covariance};
}

}  // namespace opal
