#pragma once

#include <opal/local_map/local_map.hpp>

#include <Eigen/Core>

namespace opal {

/// A motion as something measured it.
struct Motion {
  Pose2 T_before_now;
  Eigen::Matrix3d covariance;  ///< of (x, y, heading) in the frame before
};

/// The motion from one scan to the next.
struct ScanMotion {
  Motion matched;  ///< as scan matching tells it
  Motion fused;    ///< as odometry and scan matching together tell it; as odometry if no match was found
};

/// Takes the next scan into a local map, without features.
ScanMotion next_motion(LocalMap& local_map, const Sample& sample, const LocalMapOptions& options);

}  // namespace opal
