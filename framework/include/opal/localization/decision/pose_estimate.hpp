#pragma once

#include <opal/common/geometry.hpp>

#include <vector>

namespace opal {

enum class Status { searching, ambiguous, localized, lost };
OPAL_EXPORT const char* name_of(Status status);

/// Where the robot is, as far as known.
struct PoseEstimate {
  double stamp_s = 0;
  Status status = Status::searching;
  Pose2 T_map_base;  ///< of the best hypothesis; meaningless while searching without hypotheses
  bool has_pose = false;
  double probability = 0;  ///< that the best hypothesis is right, "none of these" included
  double none = 1;         ///< that neither the best nor any other hypothesis is right
  int hypotheses = 0;
  int best = -1;  ///< Hypothesis::id
  struct Alternative {
    int hypothesis = -1;
    Pose2 T_map_base;
    double probability = 0;
  };
  std::vector<Alternative> alternatives;  ///< at other places, most probable first
};

}  // namespace opal
