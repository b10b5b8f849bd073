#pragma once

#include <opal/local_map/local_map.hpp>

#include <deque>
#include <vector>

namespace opal {

/// One-sigma uncertainty of odometry over one motion: (x, y, heading) [m, m, rad].
OPAL_EXPORT Eigen::Vector3d odometry_sigma(const Pose2& T_from_to, const LocalMapOptions& options);

/// Points of the last keyframes around `position`, oldest keyframe first, in frame `local`, thinned.
std::vector<Point> points_around(const Point& position, const std::deque<Keyframe>& keyframes);

}  // namespace opal
