#pragma once

#include "reference_grid.hpp"

#include <span>
#include <vector>

namespace opal::point_to_line {

/// Tries poses on a grid over +-`sigmas` standard deviations around the guess (a small correlative search, Olson
/// 2009, on one level): few points of the scan, rated by how near the reference is, and by the prior.
/// @return the best pose, then the best one clearly apart from it, best first; at least one.
std::vector<Pose2> search_poses(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& guess,
                                const Eigen::Vector3d& guess_sigma, double sigmas);

}  // namespace opal::point_to_line
