#pragma once

#include "refinement.hpp"

#include <opal/local_map/scan_matcher.hpp>

namespace opal::point_to_line {

struct MatcherOptions {
  int max_points = 150;      ///< points of the scan that are refined with
  int search_points = 60;    ///< points of the scan that the search rates
  double search_sigmas = 3;  ///< how far around the guess to search, in standard deviations
  double min_inlier_share = 0.3;
  RefinementOptions refinement;
};

/// Searches poses around the guess on a grid, then lays the points of the scan on the lines that the reference
/// points outline. Finds its way back from errors of several degrees and decimetres; a direction in which nothing
/// holds the scan keeps the guess.
class PointToLineMatcher : public ScanMatcher {
 public:
  explicit PointToLineMatcher(MatcherOptions options) : options_(options) {}
  ScanMatch match(std::span<const Point> reference, std::span<const Point> scan, const Pose2& guess,
                  const Eigen::Vector3d& guess_sigma) const override;

 private:
  MatcherOptions options_;
};

}  // namespace opal::point_to_line
