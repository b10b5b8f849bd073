#pragma once

#include "reference_grid.hpp"

#include <opal/local_map/scan_matcher.hpp>

#include <span>

namespace opal::point_to_line {

struct RefinementOptions {
  int iterations = 10;
  double point_sigma_m = 0.05;  ///< larger than range noise: neighbouring points share their errors
  double inlier_distance_m = 0.1;
  double robust_scale_m = 0.1;  ///< of the Cauchy weight, at the end
};

/// What the guess from odometry knows.
struct Prior {
  Pose2 T_reference_scan;
  Eigen::Vector3d sigma;  ///< (x, y, heading) [m, m, rad]
};

/// Pose after refinement, with what is needed to compare and judge it.
struct Refined {
  ScanMatch match;  ///< converged: the steps became small; its share of inliers is not set
  double cost = 0;  ///< robust cost with prior [nat]; lower is better
};

/// Robust point-to-line Gauss-Newton from `start` (Chen and Medioni 1991; Censi 2008), with the prior as one more
/// measurement: where the points do not tell (along a corridor), the guess stays.
Refined refine(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& start, const Prior& prior,
               const RefinementOptions& options);

/// Share of the points that lie on the reference from this pose.
double inlier_share(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& T_reference_scan,
                    const RefinementOptions& options);

}  // namespace opal::point_to_line
