#include "localization/alignment/pose_step.hpp"
#include "survey/scan_on_map.hpp"

#include <Eigen/Dense>

namespace opal {
namespace {

// Neighbouring points share the errors of what they lie on: each counts like a reading of this standard deviation.
constexpr double kPointSigma_m = 0.1;
constexpr double kReach_m = 0.8;
constexpr double kRobust_m = 0.12;
constexpr int kIterations = 5;

}  // namespace

Pose2 align_with(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                 const Pose2& guess, const Eigen::Matrix3d& information) {
  Pose2 pose = guess;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const double sigma = iteration == 0 ? 2 * kRobust_m : kRobust_m;
    const Point eye = pose * laser;
    Eigen::Matrix3d H = information;
    Eigen::Vector3d g = information * step_between(guess, pose);
    for (const Point& point : points) {
      const Point lever = pose.rotate(point), p = pose.position() + lever;
      const int k = expected.nearest(eye, p, kReach_m);
      if (k < 0) continue;
      const SurfaceOffset at = offset_from(expected.all()[k].surface, p);
      const double weight = robust_weight(at.offset_m, sigma) / (kPointSigma_m * kPointSigma_m);
      const Eigen::Vector3d J(at.normal.x(), at.normal.y(), cross(lever, at.normal));
      H += weight * J * J.transpose();
      g += weight * at.offset_m * J;
    }
    const Eigen::Vector3d step = limited(-H.ldlt().solve(g));
    if (!step.allFinite()) break;
    pose = stepped(pose, step);
    if (step.head<2>().norm() < 0.002 && std::abs(step.z()) < 0.0005) break;
  }
  return pose;
}

double share_on(const ExpectedFeatures& expected, std::span<const Point> points, const Point& laser,
                const Pose2& T_map_base) {
  const Point eye = T_map_base * laser;
  int on = 0;
  for (const Point& point : points) on += expected.nearest(eye, T_map_base * point, kOnSurface_m) >= 0;
  return points.empty() ? 0 : on / static_cast<double>(points.size());
}

}  // namespace opal
