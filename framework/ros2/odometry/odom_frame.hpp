#pragma once

#include <string>

namespace opal::ros2 {

/// The frame of odometry that the transform from the map leads to.
struct OdomFrame {
  std::string frame;
  std::string words;  ///< what a person should know of it; empty: nothing
};

/// @param stated  by options. @param is_stated  somebody has given the option; otherwise it is the usual name.
/// @param named  by messages of odometry; empty: transforms are the odometry, or there is no name.
OdomFrame odom_frame_of(const std::string& stated, bool is_stated, const std::string& named);

}  // namespace opal::ros2
