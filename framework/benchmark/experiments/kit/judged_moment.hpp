#pragma once

#include <opal/localization/localizer.hpp>
#include "evaluation/pose_tolerance.hpp"

namespace opal::experiments {

/// What was said about one scan, beside the truth.
struct JudgedMoment {
  double time_s = 0, driven_m = 0;  ///< since the start
  Pose2 truth, estimate;            ///< T_map_base
  bool has_pose = false;
  Status status = Status::searching;
  int hypotheses = 0;
  double cpu_ms = 0;       ///< of the update; 0: the scan was none
  bool under_way = false;  ///< to the goal, where there is one

  double error_m() const { return distance_m(truth, estimate); }
  bool right() const { return has_pose && kRightPose.holds(estimate, truth); }
  bool localized() const { return has_pose && status == Status::localized; }
};

}  // namespace opal::experiments
