#include "line_fit.hpp"

#include <cmath>

namespace opal::grid_importer {
namespace {

double spread_difference(const Eigen::Matrix2d& s) { return std::hypot(s(0, 0) - s(1, 1), 2 * s(0, 1)); }

}  // namespace

void LineFit::add(const CellPoint& p, double weight) {
  const CellPoint d = p - origin_;
  weight_ += weight;
  sum_ += weight * d;
  squares_ += weight * d * d.transpose();
}

Eigen::Matrix2d LineFit::scatter() const { return squares_ / weight_ - mean() * mean().transpose(); }

Line LineFit::line(const CellPoint& towards) const {
  const Eigen::Matrix2d s = scatter();
  // Angle of the main axis: tan(2 t) = 2 s_xy / (s_xx - s_yy).
  CellPoint tangent = unit_vector(0.5 * std::atan2(2 * s(0, 1), s(0, 0) - s(1, 1)));
  if (tangent.dot(towards) < 0) tangent = -tangent;
  return {origin_ + mean(), tangent};
}

double LineFit::linearity() const {
  const Eigen::Matrix2d s = scatter();
  return s.trace() > 1e-9 ? spread_difference(s) / s.trace() : 0;
}

double LineFit::rms() const {
  const Eigen::Matrix2d s = scatter();
  return std::sqrt(std::max(0.0, (s.trace() - spread_difference(s)) / 2));
}

}  // namespace opal::grid_importer
