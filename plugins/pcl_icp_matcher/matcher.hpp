#pragma once

#include <opal/local_map/scan_matcher.hpp>

namespace opal::pcl_icp {

struct MatcherOptions {
  int max_points = 200;  ///< points of the scan that are used
  int iterations = 30;
  double correspondence_m = 0.5;  ///< points farther from all reference points are left out
  double inlier_distance_m = 0.1;
  double min_inlier_share = 0.3;
  double point_sigma_m = 0.1;  ///< for the covariance
};

/// PCL's point-to-point iterative closest point, restricted to the plane, started at the guess. It does not search:
/// the guess must be good to about half of correspondence_m. For comparison with other matchers.
class PclIcpMatcher : public ScanMatcher {
 public:
  explicit PclIcpMatcher(MatcherOptions options) : options_(options) {}
  ScanMatch match(std::span<const Point> reference, std::span<const Point> scan, const Pose2& guess,
                  const Eigen::Vector3d& guess_sigma) const override;

 private:
  MatcherOptions options_;
};

}  // namespace opal::pcl_icp
