#pragma once

#include <opal/local_map/local_map.hpp>

#include <deque>
#include <vector>

namespace opal {

/// Motion between two neighbouring keyframes as odometry or scan matching measured it.
struct RelativePose {
  KeyframeId from = {};
  KeyframeId to = {};
  Pose2 T_from_to;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of (x, y, heading) in frame `from`
};

/// Solves for the poses of the horizon that fit odometry, scan matches and all measurements of features best
/// (thesis 3.3.1 and A.1.1) and writes them to the keyframes. The oldest pose stays. Features are not changed:
/// estimate them anew.
/// @return false if there was nothing to solve, or the solution was not usable; the poses are unchanged then.
bool optimize_poses(std::deque<Keyframe>& keyframes, const std::vector<LocalFeature>& features,
                    const std::vector<RelativePose>& motions, const LocalMapOptions& options);

}  // namespace opal
