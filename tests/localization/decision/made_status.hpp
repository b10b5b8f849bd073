#pragma once

#include "localization/decision/status.hpp"

#include <catch2/catch.hpp>

#include <vector>

namespace opal {

inline constexpr double kDecisionMemory = 0.99;
inline const Pose2 kHere(3, 2, 0.5), kThere(20, 9, 2), kElsewhere(-8, 4, -1);

/// In view of walls on all sides. @param T_map_base  where the robot is now by it.
inline Live hypothesis(int id, const Pose2& T_map_base, double nat, double scan_nat = 1,
                       const Pose2& T_local_base = Pose2()) {
  Live live;
  live.hypothesis.id = HypothesisId(id);
  live.hypothesis.T_map_local = T_map_base * T_local_base.inverse();
  live.hypothesis.log_likelihood = nat;
  live.scan_nat = scan_nat;
  const Alignment walls{T_map_base, Eigen::Vector3d(50, 50, 500).asDiagonal(), Eigen::Matrix3d::Zero()};
  live.pose.update({T_map_base, T_local_base}, walls, 1, {});
  return live;
}

/// Estimates of a robot that stands at the origin of the local frame.
struct Answer {
  explicit Answer(const StatusOptions& options = {}) : estimator(options, kDecisionMemory) {}
  PoseEstimate to(const std::vector<Live>& alive, const Circumstances& now = {}) {
    return estimator.estimate(alive, Pose2(), ++stamp_s, now);
  }
  /// @return after how many whole pieces of evidence for one place it is localized; 1000: never.
  double weight_until_localized(const Circumstances& now) {
    double weight = 0;
    to({hypothesis(1, kHere, 20)}, now);  // the place is new
    while (weight < 999 && !estimator.localized()) {
      weight += now.tempering_weight;
      to({hypothesis(1, kHere, 20)}, now);
    }
    return weight;
  }
  StatusEstimator estimator;
  double stamp_s = 0;
};

/// One that is localized here.
inline Answer localized_here() {
  Answer answer;
  answer.weight_until_localized({});
  REQUIRE(answer.estimator.localized());
  return answer;
}

}  // namespace opal
