#pragma once

#include "sensing/trajectory.hpp"

#include <string>
#include <vector>

namespace opal::ros2 {

/// What one source of odometry said for some seconds.
struct OdometrySource {
  std::string name;                      ///< "/odom", "the transform on /tf"
  std::string odom_frame, base_frame;    ///< poses are of the robot, base_frame, in odom_frame
  std::vector<StampedPose> T_odom_base;  ///< by the clock of the robot, in the order of arrival
};

/// What a user should know of two sources in words: they differ in motion by more than 5 %, or in their frames, or
/// neither moved. They are compared over the time in which both speak. Empty: they agree.
/// @param used  the one that is localized with. @param other  the other one.
std::vector<std::string> disagreements(OdometrySource used, OdometrySource other);

}  // namespace opal::ros2
