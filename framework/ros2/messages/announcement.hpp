#pragma once

#include <opal/live/live_localizer.hpp>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace opal::ros2 {

/// Names of frames and how long a transform holds.
struct FrameOptions {
  std::string map = "map";           ///< fixed to the building
  std::string odom = "odom";         ///< fixed to the start of odometry
  double transform_tolerance_s = 1;  ///< a transform is stamped so much later than its scan
};

/// Where a frame lies.
struct PlacedFrame {
  double stamp_s = 0;
  std::string parent, child;
  Pose2 T_parent_child;
};

/// The pose of a robot that is localized.
struct LocalizedPose {
  double stamp_s = 0;
  Pose2 T_map_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of x, y [m] and heading [rad]
};

/// A place where the robot may be.
struct PossiblePlace {
  Pose2 T_map_base;
  double probability = 0;
};

/// What the rest of the robot is told after a scan. What is absent is not published.
struct Announcement {
  double stamp_s = 0;  ///< of the scan
  std::optional<PlacedFrame> map_to_odom;
  std::optional<LocalizedPose> pose;
  std::vector<PossiblePlace> places;  ///< most probable first
};

/// Transform and pose only while localized; places while nothing is decided; of a lost robot nothing.
Announcement announcement_of(const LiveAnswer& answer, const FrameOptions& frames);

}  // namespace opal::ros2
