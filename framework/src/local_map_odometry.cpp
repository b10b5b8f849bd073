#include "local_map_odometry.hpp"

#include <algorithm>

namespace opal {
namespace {

// A standing robot's odometry still jitters, and stamps of scan and odometry differ by some milliseconds.
constexpr double kLeastSigma_m = 0.02;
constexpr double kLeastSigma_rad = 0.01;

constexpr std::size_t kReferenceKeyframes = 5;
constexpr double kReferenceRange_m = 15.0;  ///< farther points are too sparse for their direction to be known
constexpr double kReferenceSpacing_m = 0.04;

/// Points of one keyframe, in frame `local`, no nearer to their predecessor than the spacing.
void append_points(std::vector<Point>& points, const Keyframe& keyframe, const Point& position) {
  Point last(1e9, 1e9);
  for (const Point& p_base : keyframe.points) {
    const Point p = keyframe.T_local_base * p_base;
    if ((p - last).squaredNorm() < kReferenceSpacing_m * kReferenceSpacing_m) continue;
    if ((p - position).squaredNorm() > kReferenceRange_m * kReferenceRange_m) continue;
    points.push_back(p);
    last = p;
  }
}

}  // namespace

Eigen::Vector3d odometry_sigma(const Pose2& T_from_to, const LocalMapOptions& options) {
  const double driven_m = T_from_to.position().norm();
  const double turned_rad = std::abs(T_from_to.heading_rad());
  const double sigma_m = std::hypot(kLeastSigma_m, options.odometry_sigma_per_m * driven_m);
  const double sigma_rad = std::hypot(kLeastSigma_rad, options.odometry_heading_sigma_per_rad * turned_rad,
                                      options.odometry_heading_sigma_per_m * driven_m);
  return {sigma_m, sigma_m, sigma_rad};
}

std::vector<Point> points_around(const Point& position, const std::deque<Keyframe>& keyframes) {
  const std::size_t count = std::min(kReferenceKeyframes, keyframes.size());
  std::vector<Point> points;
  points.reserve(count * 400);
  for (std::size_t i = keyframes.size() - count; i < keyframes.size(); ++i)
    append_points(points, keyframes[i], position);
  return points;
}

}  // namespace opal
