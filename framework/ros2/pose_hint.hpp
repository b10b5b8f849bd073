#pragma once

#include "ros2/incoming.hpp"

#include <opal/localization/search/pose_hint.hpp>

#include <optional>
#include <string>

namespace opal::ros2 {

/// A hint as it was received: somebody may say it in another frame than the map's.
struct FramedHint {
  std::string frame;
  PoseHint hint;
};

/// geometry_msgs/PoseWithCovarianceStamped. @return nullopt for a damaged message. A covariance of zeros is replaced by
/// that of RViz.
std::optional<FramedHint> decode_pose_hint(recording::Bytes message);
/// rosgraph_msgs/Clock, in seconds.
std::optional<double> decode_clock(recording::Bytes message);
/// The only topic of odometry, or /odom; empty if there is none, or several.
std::string usual_odometry(const std::vector<Offer>& offers);

}  // namespace opal::ros2
