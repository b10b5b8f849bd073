#include "arc_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace opal::circles {
namespace {

/// Weighted normal equations of one Gauss-Newton step in (x, y, radius).
struct NormalEquations {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  double chi2 = 0;

  void add(const Eigen::Vector3d& jacobian, double residual, double variance) {
    information += jacobian * jacobian.transpose() / variance;
    gradient += jacobian * residual / variance;
    chi2 += residual * residual / variance;
  }
};

/// Circle through points: x^2 + y^2 = 2 a x + 2 b y + c, linear in a, b, c (Kasa 1976).
Eigen::Vector3d kasa_circle(std::span<const ScanPoint> hits) {
  Point mean = Point::Zero();
  for (const ScanPoint& hit : hits) mean += hit.position / static_cast<double>(hits.size());
  NormalEquations sums;
  for (const ScanPoint& hit : hits) {
    const Point p = hit.position - mean;
    sums.add({2 * p.x(), 2 * p.y(), 1}, p.squaredNorm(), 1);
  }
  const Eigen::Vector3d abc = sums.information.ldlt().solve(sums.gradient);
  return {mean.x() + abc.x(), mean.y() + abc.y(), std::sqrt(std::max(0.0, abc.z() + abc.head<2>().squaredNorm()))};
}

/// A cylinder's apparent half width h gives sin h = r / D, and its nearest hit D - r: both together the
/// radius. Used where the hits are too few or too straight for Kasa's circle.
Eigen::Vector3d outlined_circle(const Arc& arc) {
  const double full = std::acos(std::clamp(arc.clockwise_edge.dot(arc.counter_clockwise_edge), -1.0, 1.0));
  double nearest = arc.hits.front().range_m;
  for (const ScanPoint& hit : arc.hits) nearest = std::min(nearest, hit.range_m);
  const double sine = std::min(std::sin(full / 2), 0.9);
  const double radius = nearest * sine / (1 - sine);
  const Point centre = (nearest + radius) * (arc.clockwise_edge + arc.counter_clockwise_edge).normalized();
  return {centre.x(), centre.y(), radius};
}

NormalEquations equations_at(const Eigen::Vector3d& circle, const Arc& arc, const ReadingNoise& noise) {
  NormalEquations sums;
  const Point centre = circle.head<2>();
  for (const ScanPoint& hit : arc.hits) {
    const Point outwards = (hit.position - centre).normalized();
    const double residual = (hit.position - centre).norm() - circle.z();
    sums.add({-outwards.x(), -outwards.y(), -1}, residual, variance_across(hit, outwards, noise));
  }
  const double edge_sigma = arc.edge_sigma_rad * centre.norm();
  const Point left_cw = left_of(arc.clockwise_edge);
  const Point right_ccw = -left_of(arc.counter_clockwise_edge);
  for (const Point& inwards : {left_cw, right_ccw})
    sums.add({inwards.x(), inwards.y(), -1}, inwards.dot(centre) - circle.z(), edge_sigma * edge_sigma);
  return sums;
}

double edge_error_sigmas(const Eigen::Vector3d& circle, const Arc& arc) {
  const Point centre = circle.head<2>();
  const double cw = left_of(arc.clockwise_edge).dot(centre) - circle.z();
  const double ccw = -left_of(arc.counter_clockwise_edge).dot(centre) - circle.z();
  return std::max(std::abs(cw), std::abs(ccw)) / (arc.edge_sigma_rad * centre.norm());
}

}  // namespace

std::optional<ArcFit> fit_arc(const Arc& arc, const ReadingNoise& noise) {
  constexpr int kMaxSteps = 15;
  Eigen::Vector3d circle = kasa_circle(arc.hits);
  const Eigen::Vector3d outlined = outlined_circle(arc);
  if (!circle.allFinite() || std::abs(circle.z() - outlined.z()) > 0.5 * outlined.z()) circle = outlined;
  bool converged = false;
  for (int step = 0; step < kMaxSteps && !converged; ++step) {
    const NormalEquations sums = equations_at(circle, arc, noise);
    const Eigen::Vector3d change = sums.information.ldlt().solve(-sums.gradient);
    circle += change;
    if (!circle.allFinite() || circle.z() <= 0) return std::nullopt;
    converged = change.norm() < 1e-6;
  }
  if (!converged) return std::nullopt;

  ArcFit fit;
  fit.circle = {circle.head<2>(), circle.z()};
  const NormalEquations sums = equations_at(circle, arc, noise);
  const double freedom = static_cast<double>(arc.hits.size()) + 2 - 3;
  fit.covariance = sums.information.inverse() * std::max(1.0, sums.chi2 / freedom);
  for (const ScanPoint& hit : arc.hits)
    fit.rms_m += std::pow((hit.position - fit.circle.center).norm() - circle.z(), 2);
  fit.rms_m = std::sqrt(fit.rms_m / static_cast<double>(arc.hits.size()));
  fit.edge_error_sigmas = edge_error_sigmas(circle, arc);
  return fit;
}

}  // namespace opal::circles
