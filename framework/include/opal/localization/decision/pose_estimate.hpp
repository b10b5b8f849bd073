#pragma once

#include <opal/common/geometry.hpp>
#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/map/storeys.hpp>

#include <Eigen/Core>

#include <vector>

namespace opal {

/// What is known of the robot's place.
enum class Status {
  searching,  ///< no place stands out yet
  ambiguous,  ///< several places explain what was seen
  localized,  ///< one place explains it
  lost        ///< the robot was localized, and what it sees now contradicts that
};
/// "searching", "localized": the status as events and files write it.
OPAL_EXPORT const char* name_of(Status status);

/// Where the robot is, as far as known.
struct PoseEstimate {
  double stamp_s = 0;                 ///< of the scan, or of the odometry that carried the estimate on
  Status status = Status::searching;  ///< what the pose is worth
  Pose2 T_map_base;                   ///< of the best hypothesis; meaningless while searching without hypotheses
  bool has_pose = false;              ///< false: there is no hypothesis
  /// Of (x, y, heading) in the map frame [m, m, rad], if the robot is at this place.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// That the robot is at this place: the sum over all hypotheses within 0.7 m and 0.2 rad of the best one, lowered by
  /// the probability that the robot was kidnapped.
  double probability = 0;
  double none = 1;         ///< that no hypothesis is right, be it that the robot was kidnapped
  int hypotheses = 0;      ///< number that are alive
  HypothesisId best = {};  ///< the best one
  /// Building, storey and the pose in the storey's own frame, of the best hypothesis; empty names if the map holds no
  /// storeys, or without a pose.
  PlaceInBuilding place;
  /// Another place that explains what was seen.
  struct Alternative {
    HypothesisId hypothesis = {};  ///< the best one there
    Pose2 T_map_base;              ///< of that hypothesis
    double probability = 0;        ///< that the robot is there: a sum as `PoseEstimate::probability`
  };
  std::vector<Alternative> alternatives;  ///< at other places, most probable first
};

}  // namespace opal
