#pragma once

#include "survey/expected_features.hpp"

#include "survey/pose_tracker.hpp"

#include <span>
#include <vector>

namespace opal {

/// Slides points onto the surfaces where they are believed to be, against what was known of the pose before.
/// @param points  base_link frame [m]. @param information  of `guess` (x, y, heading), map frame.
/// @return T_map_base near `guess`.
Pose2 align_with(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                 const Pose2& guess, const Eigen::Matrix3d& information);

/// Share of the points that lie on an expected surface.
double share_on(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                const Pose2& T_map_base);

/// Looks for every expected surface in a scan that is roughly in place. A surface that lies where it is believed to be
/// takes its points there; one that is nowhere may be elsewhere, as far as wall_error_m, if a line of its direction and
/// about its size is there. Best seen first.
/// @param points  base_link frame [m], by increasing bearing.
std::vector<MapMeasurement> measure(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                                    const Pose2& T_map_base, const PoseTrackerOptions& options);

/// How much of a measured face was covered by points [m].
double covered_m(const MapMeasurement& measurement);

}  // namespace opal
