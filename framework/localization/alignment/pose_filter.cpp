#include "localization/alignment/pose_filter.hpp"

#include "localization/alignment/pose_step.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace opal {

/// What is unknown of the heading shifts the pose the more the further the robot has driven.
Eigen::Matrix3d PoseFilter::known_here(const Pose2& predicted, const Pose2& T_local_base) const {
  const Point moved = -predicted.rotate((T_local_base.inverse() * T_local_base_).position());
  Eigen::Matrix3d there_of_here = Eigen::Matrix3d::Identity();
  there_of_here(0, 2) = moved.y();
  there_of_here(1, 2) = -moved.x();
  return there_of_here.transpose() * known_ * there_of_here;
}

Pose2 PoseFilter::update(const Pose2& predicted, const Alignment& scan, double tempering_weight,
                         const Pose2& T_local_base, const PoseFilterOptions& options) {
  constexpr double kNothing = 1e-3;
  const Eigen::Matrix3d said = tempering_weight * (scan.by_points + scan.by_guess);
  if (!said.allFinite()) return scan.T_map_base;
  const Eigen::Vector3d step = step_between(predicted, scan.T_map_base);
  const Eigen::Matrix3d kept = known_here(predicted, T_local_base) * std::pow(options.memory, tempering_weight);
  const double trust = robust_weight(step.head<2>().norm(), options.jump_m);
  known_ = std::pow(trust, tempering_weight) * kept + tempering_weight * scan.by_points;
  T_local_base_ = T_local_base;
  if (kept.trace() < kNothing) return scan.T_map_base;
  const Eigen::Vector3d by_all = (trust * kept + said).ldlt().solve(said * step);
  return by_all.allFinite() ? stepped(predicted, by_all) : scan.T_map_base;
}

Eigen::Matrix3d PoseFilter::covariance() const {
  // Points of one wall share their errors: together they say as much as a few of 0.06 m would.
  constexpr double kPoint_m = 0.3;
  // The map's own error does not average out; position and heading on the recorded sites.
  constexpr double kMap_m = 0.04, kMap_rad = 0.008;
  // Nobody knows less than that, 5 m and half a turn.
  const Eigen::Vector3d least(1 / 25.0, 1 / 25.0, 0.1);
  const Eigen::Matrix3d information = known_ / (kPoint_m * kPoint_m) + Eigen::Matrix3d(least.asDiagonal());
  const Eigen::Vector3d map(kMap_m * kMap_m, kMap_m * kMap_m, kMap_rad * kMap_rad);
  return information.inverse() + Eigen::Matrix3d(map.asDiagonal());
}

}  // namespace opal
