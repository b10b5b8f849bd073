#pragma once

#include "ros2/incoming.hpp"

#include <opal/common/geometry.hpp>

namespace opal::ros2 {

/// Where somebody says that the robot is.
struct PoseHint {
  std::string frame;
  Pose2 T_map_base;
  double sigma_m = 0, sigma_rad = 0;
};

/// geometry_msgs/PoseWithCovarianceStamped. @return nullopt for a damaged message. A covariance of zeros is replaced by
/// that of RViz.
std::optional<PoseHint> decode_pose_hint(recording::Bytes message);
/// rosgraph_msgs/Clock, in seconds.
std::optional<double> decode_clock(recording::Bytes message);
/// The only topic of odometry, or /odom; empty if there is none, or several.
std::string usual_odometry(const std::vector<Offer>& offers);

}  // namespace opal::ros2
