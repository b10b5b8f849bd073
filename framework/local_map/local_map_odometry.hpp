#pragma once

#include <opal/local_map/local_map.hpp>

#include <Eigen/Core>

namespace opal {

/// One-sigma uncertainty of odometry over one motion: (x, y, heading) [m, m, rad].
OPAL_EXPORT Eigen::Vector3d odometry_sigma(const Pose2& T_from_to, const LocalMapOptions& options);

}  // namespace opal
