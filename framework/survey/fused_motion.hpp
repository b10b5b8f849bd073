#pragma once

#include <opal/common/geometry.hpp>

#include <Eigen/Core>

namespace opal {

/// A covariance of (x, y, heading) in the axes of another frame.
Eigen::Matrix3d turned(const Eigen::Matrix3d& covariance, const Pose2& T_to_from);

/// A motion as something measured it.
struct Motion {
  Pose2 T_before_now;
  Eigen::Matrix3d covariance;  ///< of (x, y, heading) in the frame before
};

/// Two measurements of one motion; where they contradict each other, the second is right.
Motion fused(const Motion& a, const Motion& b);

}  // namespace opal
