#include "localization/alignment/registration.hpp"

#include "localization/alignment/pose_step.hpp"

#include <Eigen/Dense>

namespace opal {
namespace {

/// Normal equations of one Gauss-Newton step in (x, y, heading) about the current pose.
struct NormalEquations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();

  void add(const Point& normal, const Point& lever, double error, double weight) {
    const Eigen::Vector3d J(normal.x(), normal.y(), cross(lever, normal));
    H += weight * J * J.transpose();
    g += weight * error * J;
  }
};

/// Signed distance to a surface, and its normal there.
struct Residual {
  double error = 0;
  Point normal = Point::Zero();
  bool valid = false;
};

Residual residual_to(const Surface& surface, const Point& p) {
  const Point from = p - surface.origin;
  if (surface.is_circle()) {
    const double distance = from.norm();
    if (distance < 1e-6) return {};
    return {distance - surface.size_m, from / distance, true};
  }
  constexpr double kOverhang_m = 0.2;
  const double along = surface.direction.dot(from);
  return {surface.normal().dot(from), surface.normal(), along > -kOverhang_m && along < surface.size_m + kOverhang_m};
}

void linearize(const MapView& map, const ObservedScan& scan, const Pose2& pose, double sigma_m,
               NormalEquations& equations) {
  const Point eye = pose * scan.laser_position;
  for (const Point& point : scan.points) {
    const Point lever = pose.rotate(point), p = pose.position() + lever;
    const MapFeatureNumber number = map.nearest_facing(p, p - eye);
    if (!number.exists()) continue;
    const Residual residual = residual_to(map.surface(number), p);
    if (residual.valid) equations.add(residual.normal, lever, residual.error, robust_weight(residual.error, sigma_m));
  }
}

NormalEquations linearize(const MapView& map, std::span<const ObservedScan> scans, const Pose2& pose, double sigma_m) {
  NormalEquations equations;
  for (const ObservedScan& scan : scans) linearize(map, scan, pose, sigma_m, equations);
  return equations;
}

double number_of_points(std::span<const ObservedScan> scans) {
  std::size_t points = 0;
  for (const ObservedScan& scan : scans) points += scan.points.size();
  return static_cast<double>(points);
}

}  // namespace

Alignment align_with_map(const MapView& map, std::span<const ObservedScan> scans, const Pose2& guess,
                         const RefinementOptions& options) {
  Alignment aligned{guess};
  Pose2& pose = aligned.T_map_base;
  const double n = number_of_points(scans);
  const Eigen::Vector3d prior(options.prior_position * n, options.prior_position * n, options.prior_heading * n);
  aligned.by_guess = prior.asDiagonal();
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    // The first step looks twice as far, so that a poor guess is not stuck.
    const double sigma = iteration == 0 ? 2 * options.sigma_m : options.sigma_m;
    NormalEquations equations = linearize(map, scans, pose, sigma);
    aligned.by_points = equations.H;
    equations.H.diagonal() += prior + Eigen::Vector3d(1e-3, 1e-3, 1e-2);
    equations.g += prior.cwiseProduct(step_between(guess, pose));
    const Eigen::Vector3d step = limited(-equations.H.ldlt().solve(equations.g));
    if (!step.allFinite()) break;
    pose = stepped(pose, step);
    if (step.head<2>().norm() < 0.003 && std::abs(step.z()) < 0.0007) break;
  }
  return aligned;
}

Pose2 refine_on_map(const MapView& map, std::span<const ObservedScan> scans, const Pose2& guess,
                    const RefinementOptions& options) {
  return align_with_map(map, scans, guess, options).T_map_base;
}

double likelihood_field_score(const MapView& map, std::span<const Point> points, const Pose2& T_map_base) {
  float sum = 0;
  for (const Point& point : points) sum += map.likelihood_field(T_map_base * point);
  return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

}  // namespace opal
