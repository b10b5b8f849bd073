#pragma once

#include <opal/common/geometry.hpp>

namespace opal {

/// Where somebody says that the robot is.
struct PoseHint {
  Pose2 T_map_base;        ///< about here
  double sigma_m = 0.5;    ///< one standard deviation of the position, along either axis
  double sigma_rad = 0.2;  ///< one standard deviation of the heading
};

}  // namespace opal
