#include "refinement.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <optional>

namespace opal::point_to_line {
namespace {

constexpr double kFirstScale = 4;         ///< the robust scale starts this much wider
constexpr double kScaleShrinks = 0.7;     ///< per iteration
constexpr double kPointToPoint = 0.1;     ///< weight where the outline has no direction: its points hit elsewhere
constexpr double kSharedErrors = 3;       ///< variance of matches on six recorded logs over that of free points
constexpr double kSmallStep = 1e-4;       ///< [m], [rad]
constexpr double kMoreThanSpurious = 20;  ///< so many times what wrong normals feign, or the points say nothing there

/// Normal equations of one iteration.
struct Equations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  Eigen::Matrix2d spurious = Eigen::Matrix2d::Zero();  ///< information about the position that wrong normals feign

  void add(const Eigen::Vector3d& jacobian, double residual, double weight) {
    H.noalias() += weight * jacobian * jacobian.transpose();
    g.noalias() += weight * residual * jacobian;
  }
};

/// A point beside the surfel that is nearest to it.
struct Residual {
  const Surfel* surfel;  ///< null: nothing is in reach
  Point turned;          ///< the point, in axes of the reference, from the scan's origin
  Point away;            ///< from the surfel's mean
  double value = 0;      ///< distance from its line; from its mean if it has no direction

  bool on_line() const { return !surfel->normal.isZero(); }
  bool is_beyond_end(double cell_m) const { return surfel->end.dot(away) > 0.5 * cell_m; }
};

Residual residual_of(const ReferenceGrid& grid, const Pose2& pose, const Point& p) {
  Residual residual{nullptr, pose.rotate(p), Point::Zero()};
  const Point moved = pose.position() + residual.turned;
  residual.surfel = grid.nearest(moved);
  if (!residual.surfel) return residual;
  residual.away = moved - residual.surfel->mean;
  residual.value = residual.on_line() ? residual.surfel->normal.dot(residual.away) : residual.away.norm();
  return residual;
}

class Refinement {
 public:
  Refinement(const ReferenceGrid& grid, std::span<const Point> scan, const Prior& prior,
             const RefinementOptions& options)
      : grid_(grid), scan_(scan), prior_(prior), options_(options) {}

  Equations equations_at(const Pose2& pose, double scale_m) const {
    Equations e;
    e.H.diagonal() += prior_information();
    e.g += prior_information().cwiseProduct(prior_residual(pose));
    for (const Point& p : scan_) add_point(e, residual_of(grid_, pose, p), scale_m * scale_m);
    return e;
  }

  /// Robust, with the prior [nat].
  double cost_at(const Pose2& pose, double scale_m) const {
    const Eigen::Vector3d off = prior_residual(pose);
    double cost = 0.5 * off.dot(prior_information().cwiseProduct(off));
    for (const Point& p : scan_) cost += cost_of(residual_of(grid_, pose, p), scale_m * scale_m);
    return cost;
  }

  /// Covariance at the solution: prior and points, the latter with the errors they share.
  Eigen::Matrix3d covariance(const Equations& e) const {
    const Eigen::Matrix3d known = prior_information().asDiagonal();
    return (known + (e.H - known) / kSharedErrors).inverse();
  }

  /// A search finds any position along a corridor as good, and wrong normals would hold it where it was found: there,
  /// the guess is the better start (Zhang, Kaess and Singh 2016).
  /// @param e  at the pose that was found.
  /// @return none where points say more.
  std::optional<Pose2> better_start(const Pose2& found, const Equations& e) const {
    const Eigen::Matrix2d known = prior_information().head<2>().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(e.H.topLeftCorner<2, 2>() - known);
    const Point weakest = axes.eigenvectors().col(0);
    if (axes.eigenvalues()[0] > kMoreThanSpurious * weakest.dot(e.spurious * weakest)) return std::nullopt;
    const Point off = found.position() - prior_.T_reference_scan.position();
    return Pose2(Point(found.position() - weakest.dot(off) * weakest), found.heading_rad());
  }

 private:
  Eigen::Vector3d prior_information() const { return prior_.sigma.cwiseAbs2().cwiseInverse(); }
  double point_information() const { return 1.0 / (options_.point_sigma_m * options_.point_sigma_m); }

  Eigen::Vector3d prior_residual(const Pose2& pose) const {
    const Point away = pose.position() - prior_.T_reference_scan.position();
    const double turned = wrap_angle(pose.heading_rad() - prior_.T_reference_scan.heading_rad());
    return {away.x(), away.y(), turned};
  }

  /// Cauchy: weight = 1 / (1 + (r / s)^2), in units of the point's variance.
  void add_point(Equations& e, const Residual& r, double scale_squared) const {
    if (!r.surfel) return;
    const Point lever = left_of(r.turned);  // derivative of the moved point by the heading
    const double weight = point_information() / (1 + r.value * r.value / scale_squared);
    if (r.on_line()) {
      const Point& n = r.surfel->normal;
      e.add({n.x(), n.y(), n.dot(lever)}, r.value, weight);
      const Point along = left_of(n);
      e.spurious.noalias() += weight * r.surfel->normal_variance * along * along.transpose();
    } else if (r.surfel->dense) {
      e.add({1, 0, lever.x()}, r.away.x(), kPointToPoint * weight);
      e.add({0, 1, lever.y()}, r.away.y(), kPointToPoint * weight);
    }
  }

  /// Cauchy: cost = s^2 / 2 log(1 + (r / s)^2). A point far from everything costs as much as one at the edge of reach.
  double cost_of(const Residual& r, double scale_squared) const {
    constexpr double kReachSquared = ReferenceGrid::kReach_m * ReferenceGrid::kReach_m;
    const double squared = (r.surfel ? r.value * r.value : kReachSquared) / scale_squared;
    return 0.5 * point_information() * scale_squared * std::log1p(squared);
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
  double scale_m = kFirstScale * options.robust_scale_m;
  Pose2 pose = start;
  Equations e = refinement.equations_at(pose, scale_m);
  if (const auto better = refinement.better_start(start, e)) {
    pose = *better;
    e = refinement.equations_at(pose, scale_m);
  }
  for (int i = 0; i < options.iterations; ++i) {
    if (i > 0) e = refinement.equations_at(pose, scale_m);
    const Eigen::Vector3d step = e.H.ldlt().solve(-e.g);
    pose = Pose2(pose.position() + step.head<2>(), pose.heading_rad() + step.z());
    const bool widest_passed = scale_m <= options.robust_scale_m;
    if (widest_passed && step.cwiseAbs().maxCoeff() < kSmallStep) break;
    scale_m = std::max(options.robust_scale_m, kScaleShrinks * scale_m);
  }
  result.match.T_reference_scan = pose;
  result.match.covariance = refinement.covariance(refinement.equations_at(pose, options.robust_scale_m));
  result.match.converged = pose.position().allFinite() && std::isfinite(pose.heading_rad());
  result.cost = refinement.cost_at(pose, options.robust_scale_m);
  return result;
}

double inlier_share(const ReferenceGrid& grid, std::span<const Point> scan, const Pose2& T_reference_scan,
                    const RefinementOptions& options) {
  const auto is_inlier = [&](const Point& p) {
    const Residual r = residual_of(grid, T_reference_scan, p);
    return r.surfel != nullptr && std::abs(r.value) < options.inlier_distance_m && !r.is_beyond_end(grid.cell_m());
  };
  return static_cast<double>(std::count_if(scan.begin(), scan.end(), is_inlier)) / static_cast<double>(scan.size());
}

}  // namespace opal::point_to_line
