#include "refinement.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace opal::point_to_line {
namespace {

constexpr double kFirstScale = 4;      ///< the robust scale starts this much wider
constexpr double kScaleShrinks = 0.7;  ///< per iteration
constexpr double kPointToPoint = 0.1;  ///< weight where the outline has no direction: its points hit elsewhere
constexpr double kSharedErrors = 3;    ///< variance of matches on six recorded logs over that of free points
constexpr double kSmallStep = 1e-4;    ///< [m], [rad]

/// Normal equations of one iteration.
struct Equations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  double cost = 0;
  int inliers = 0;

  void add(const Eigen::Vector3d& jacobian, double residual, double weight) {
    H.noalias() += weight * jacobian * jacobian.transpose();
    g.noalias() += weight * residual * jacobian;
  }
};

class Refinement {
 public:
  Refinement(const ReferenceGrid& grid, std::span<const Point> scan, const Prior& prior,
             const RefinementOptions& options)
      : grid_(grid), scan_(scan), prior_(prior), options_(options) {}

  Equations equations_at(const Pose2& pose, double scale_m) const {
    Equations e;
    add_prior(e, pose);
    for (const Point& p : scan_) add_point(e, pose, p, scale_m);
    return e;
  }

  /// Covariance at the solution: prior and points, the latter with the errors they share.
  Eigen::Matrix3d covariance(const Equations& e) const {
    const Eigen::Matrix3d known = prior_information().asDiagonal();
    return (known + (e.H - known) / kSharedErrors).inverse();
  }

 private:
  Eigen::Vector3d prior_information() const { return prior_.sigma.cwiseAbs2().cwiseInverse(); }

  void add_prior(Equations& e, const Pose2& pose) const {
    const Point away = pose.position() - prior_.T_reference_scan.position();
    const double turned = wrap_angle(pose.heading_rad() - prior_.T_reference_scan.heading_rad());
    const Eigen::Vector3d residual(away.x(), away.y(), turned);
    const Eigen::Vector3d information = prior_information();
    e.H.diagonal() += information;
    e.g += information.cwiseProduct(residual);
    e.cost += 0.5 * residual.dot(information.cwiseProduct(residual));
  }

  /// Cauchy: cost = s^2 / 2 log(1 + (r / s)^2) in units of the point's variance, weight = 1 / (1 + (r / s)^2). A point
  /// far from everything costs as much as one at the edge of reach.
  void add_point(Equations& e, const Pose2& pose, const Point& p, double scale_m) const {
    const double information = 1.0 / (options_.point_sigma_m * options_.point_sigma_m);
    const double scale_squared = scale_m * scale_m;
    const Point turned = pose.rotate(p);
    const Point moved = pose.position() + turned;
    const Surfel* surfel = grid_.nearest(moved);
    if (!surfel) {
      constexpr double reach_squared = ReferenceGrid::kReach_m * ReferenceGrid::kReach_m;
      e.cost += 0.5 * information * scale_squared * std::log1p(reach_squared / scale_squared);
      return;
    }
    const Point away = moved - surfel->mean;
    const Point lever = left_of(turned);  // derivative of the moved point by the heading
    const bool on_line = !surfel->normal.isZero();
    const double residual = on_line ? surfel->normal.dot(away) : away.norm();
    const double squared = residual * residual / scale_squared;
    const double weight = information / (1 + squared);
    e.cost += 0.5 * information * scale_squared * std::log1p(squared);
    e.inliers += std::abs(residual) < options_.inlier_distance_m;
    if (on_line) {
      const Point& n = surfel->normal;
      e.add({n.x(), n.y(), n.dot(lever)}, residual, weight);
    } else if (surfel->dense) {
      e.add({1, 0, lever.x()}, away.x(), kPointToPoint * weight);
      e.add({0, 1, lever.y()}, away.y(), kPointToPoint * weight);
    }
  }

  const ReferenceGrid& grid_;
  std::span<const Point> scan_;
  const Prior& prior_;
  const RefinementOptions& options_;
};

}  // namespace

Refined refine(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& start, const Prior& prior,
               const RefinementOptions& options) {
  const Refinement refinement(grid, scan, prior, options);
  Refined result;
  Pose2 pose = start;
  double scale_m = kFirstScale * options.robust_scale_m;
  for (int i = 0; i < options.iterations; ++i) {
    const Equations e = refinement.equations_at(pose, scale_m);
    const Eigen::Vector3d step = e.H.ldlt().solve(-e.g);
    pose = Pose2(pose.position() + step.head<2>(), pose.heading_rad() + step.z());
    const bool widest_passed = scale_m <= options.robust_scale_m;
    if (widest_passed && step.cwiseAbs().maxCoeff() < kSmallStep) break;
    scale_m = std::max(options.robust_scale_m, kScaleShrinks * scale_m);
  }
  const Equations last = refinement.equations_at(pose, options.robust_scale_m);
  result.match.T_reference_scan = pose;
  result.match.covariance = refinement.covariance(last);
  result.match.inlier_share = static_cast<double>(last.inliers) / static_cast<double>(scan.size());
  result.match.converged = pose.position().allFinite() && std::isfinite(pose.heading_rad());
  result.cost = last.cost;
  return result;
}

}  // namespace opal::point_to_line
