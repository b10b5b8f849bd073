#include "survey/fused_motion.hpp"

#include "common/covariance.hpp"
#include "local_map/local_map_odometry.hpp"
#include "localization/alignment/pose_step.hpp"

#include <Eigen/Dense>

namespace opal {
namespace {

/// Two measurements of one motion; where they contradict each other, the second is right.
Motion fused(const Motion& a, const Motion& b) {
  constexpr double kContradiction = 2.5 * 2.5;
  const Eigen::Matrix3d information = (a.covariance + b.covariance).inverse();
  const Eigen::Matrix3d gain = a.covariance * information;
  const Eigen::Vector3d apart = step_between(a.T_before_now, b.T_before_now);
  if (apart.dot(information * apart) > kContradiction) return b;
  return {stepped(a.T_before_now, gain * apart), (Eigen::Matrix3d::Identity() - gain) * a.covariance};
}

}  // namespace

ScanMotion next_motion(LocalMap& local_map, const Sample& sample, const LocalMapOptions& options) {
  const Pose2 T_before_local = local_map.T_local_base().inverse();
  const Pose2 driven = T_before_local * local_map.T_local_base_at(sample.T_odom_base);
  local_map.add(sample, {});
  const Motion matched{T_before_local * local_map.T_local_base(),
                       turned_covariance(T_before_local, local_map.last_match().covariance)};
  const Motion odometry{driven, odometry_sigma(driven, options).cwiseAbs2().asDiagonal()};
  return {matched, local_map.last_match().converged ? fused(odometry, matched) : odometry};
}

}  // namespace opal
