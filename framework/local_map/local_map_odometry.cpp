#include "local_map/local_map_odometry.hpp"

#include <algorithm>

namespace opal {
namespace {

// Keyframes that are matched against: the newest, and older ones with so much driving between them. Near neighbours
// add no view, and a chain of nothing but short steps drifts.
constexpr std::size_t kReferenceKeyframes = 5;
constexpr double kReferenceStep_m = 0.4;

constexpr double kReferenceRange_m = 20.0;  ///< farther points are too sparse for their direction to be known
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
  const double sigma_m = std::hypot(options.odometry_sigma_m, options.odometry_sigma_per_m * driven_m);
  const double sigma_rad =
      std::hypot(options.odometry_heading_sigma_rad, options.odometry_heading_sigma_per_rad * turned_rad,
                 options.odometry_heading_sigma_per_m * driven_m);
  return {sigma_m, sigma_m, sigma_rad};
}

std::vector<Point> points_around(const Point& position, const std::deque<Keyframe>& keyframes) {
  std::vector<const Keyframe*> chosen;
  for (auto it = keyframes.rbegin(); it != keyframes.rend() && chosen.size() < kReferenceKeyframes; ++it)
    if (chosen.empty() || chosen.back()->driven_m - it->driven_m >= kReferenceStep_m) chosen.push_back(&*it);
  std::vector<Point> points;
  for (auto it = chosen.rbegin(); it != chosen.rend(); ++it) append_points(points, **it, position);
  return points;
}

}  // namespace opal
