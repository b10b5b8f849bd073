#include "localization/alignment/pose_filter.hpp"

#include "common/covariance.hpp"
#include "localization/alignment/pose_step.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace opal {
namespace {

// Points of one wall share their errors: together they say as much as a few of 0.06 m would.
constexpr double kPoint_m = 0.3;

// Steps err against each other: a scan that was paired with odometry a little too early is followed by one that makes
// up for it. So much of their summed covariance is left, on recorded sites and with simulated lasers of many kinds.
constexpr double kLeftOfSteps = 0.25;

}  // namespace

/// A hypothesis is where a pattern or a search puts it, and places beside it are hypotheses of their own.
PoseFilter::PoseFilter() {
  constexpr double kFound_m = 0.3, kFound_rad = 0.05;
  const Eigen::Vector3d found(1 / (kFound_m * kFound_m), 1 / (kFound_m * kFound_m), 1 / (kFound_rad * kFound_rad));
  known_ = kPoint_m * kPoint_m * found.asDiagonal();
}

/// What is unknown of the heading shifts the pose the more the further the robot has driven, and each step adds what is
/// unknown of it (Thrun, Burgard and Fox 2005, eq. 3.34; nothing may be known).
Eigen::Matrix3d PoseFilter::known_after(const DeadReckoning& step) const {
  const Pose2 T_local_before = T_local_base_.value_or(step.T_local_base);
  const Point moved = -step.predicted.rotate((step.T_local_base.inverse() * T_local_before).position());
  Eigen::Matrix3d there_of_here = Eigen::Matrix3d::Identity();
  there_of_here(0, 2) = moved.y();
  there_of_here(1, 2) = -moved.x();
  const Eigen::Matrix3d known = there_of_here.transpose() * known_ * there_of_here;
  const Pose2 T_map_local = step.predicted * step.T_local_base.inverse();
  const Eigen::Matrix3d added = kLeftOfSteps / (kPoint_m * kPoint_m) * turned_covariance(T_map_local, step.covariance);
  return (Eigen::Matrix3d::Identity() + known * added).partialPivLu().solve(known);
}

Pose2 PoseFilter::update(const DeadReckoning& step, const Alignment& scan, double tempering_weight,
                         const PoseFilterOptions& options) {
  const Eigen::Matrix3d said = tempering_weight * (scan.by_points + scan.by_guess);
  if (!said.allFinite()) return scan.T_map_base;
  const Pose2& predicted = step.predicted;
  const Eigen::Vector3d correction = step_between(predicted, scan.T_map_base);
  const Eigen::Matrix3d kept = known_after(step) * std::pow(options.memory, tempering_weight);
  const double trust = robust_weight(correction.head<2>().norm(), options.jump_m);
  known_ = std::pow(trust, tempering_weight) * kept + tempering_weight * scan.by_points;
  T_local_base_ = step.T_local_base;
  const Eigen::Vector3d by_all = (trust * kept + said).ldlt().solve(said * correction);
  return by_all.allFinite() ? stepped(predicted, by_all) : scan.T_map_base;
}

Eigen::Matrix3d PoseFilter::covariance() const {
  // The map's own error does not average out; position and heading on the recorded sites.
  constexpr double kMap_m = 0.04, kMap_rad = 0.008;
  // Nobody knows less than that, 5 m and half a turn.
  const Eigen::Vector3d least(1 / 25.0, 1 / 25.0, 0.1);
  const Eigen::Matrix3d information = known_ / (kPoint_m * kPoint_m) + Eigen::Matrix3d(least.asDiagonal());
  const Eigen::Vector3d map(kMap_m * kMap_m, kMap_m * kMap_m, kMap_rad * kMap_rad);
  return information.inverse() + Eigen::Matrix3d(map.asDiagonal());
}

}  // namespace opal
