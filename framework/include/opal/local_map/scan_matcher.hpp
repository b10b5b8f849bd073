#pragma once

#include <opal/common/geometry.hpp>

#include <span>

namespace opal {

/// How well two point sets could be laid over each other.
struct ScanMatch {
  /// Where the scan's frame lies in the reference frame.
  Pose2 T_reference_scan;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, heading) in the reference frame [m, m, rad]
  double inlier_share = 0;                               ///< of the scan's points, in [0, 1]
  bool converged = false;                                ///< false: the pose says nothing, odometry is taken
};

/// Lays a scan over points seen before, to improve on odometry (thesis A.1.2). Stateless and thread-safe.
class OPAL_EXPORT ScanMatcher {
 public:
  virtual ~ScanMatcher();
  /// @param reference  points seen before [m], in the reference frame, in order of bearing per scan.
  /// @param scan       points of the new scan [m], in their own frame, by increasing bearing.
  /// @param guess      T_reference_scan from odometry.
  /// @param guess_sigma one-sigma uncertainty of the guess (x, y, heading) [m, m, rad].
  /// @return converged = false if the points do not tell; never throws for poor data.
  virtual ScanMatch match(std::span<const Point> reference, std::span<const Point> scan, const Pose2& guess,
                          const Eigen::Vector3d& guess_sigma) const = 0;
};

}  // namespace opal
