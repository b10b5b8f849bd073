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
  /// Of (x, y, heading) in the map frame [m, m, rad], if the best hypothesis is right. `probability` is that it is.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double probability = 0;  ///< that the best hypothesis is right, "none of these" included
  double none = 1;         ///< that neither the best nor any other hypothesis is right
  int hypotheses = 0;      ///< number that are alive
  HypothesisId best = {};  ///< the best one
  /// Building, storey and the pose in the storey's own frame, of the best hypothesis; empty names if the map holds no
  /// storeys, or without a pose.
  PlaceInBuilding place;
  /// Another place that explains what was seen.
  struct Alternative {
    HypothesisId hypothesis = {};  ///< the best one there
    Pose2 T_map_base;              ///< of that hypothesis
    double probability = 0;        ///< that it is right
  };
  std::vector<Alternative> alternatives;  ///< at other places, most probable first
};

}  // namespace opal
