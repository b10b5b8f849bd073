#pragma once

#include "grid.hpp"

namespace opal::grid_importer {

/// A directed line; the visible side is on the left. In cell units.
struct Line {
  CellPoint through = CellPoint::Zero();
  CellPoint tangent = CellPoint::UnitX();

  CellPoint normal() const { return left_of(tangent); }
  double along(const CellPoint& p) const { return tangent.dot(p - through); }
  double offset(const CellPoint& p) const { return cross(tangent, p - through); }  ///< positive on the visible side
  CellPoint at(double along) const { return through + along * tangent; }
};

/// Weighted total least squares: the line through the weighted mean, along the main axis of the scatter matrix
/// (Pearson 1901, "On lines and planes of closest fit to systems of points in space").
class LineFit {
 public:
  /// @param origin  sums are taken relative to it, so that the fit is the same wherever the points are.
  explicit LineFit(const CellPoint& origin) : origin_(origin) {}

  void add(const CellPoint& p, double weight = 1);
  double weight() const { return weight_; }

  /// @param towards  the tangent points to the side where its product with this is positive.
  Line line(const CellPoint& towards) const;
  /// How much the scatter is along one direction only: 0 for a round cloud, 1 for a line.
  double linearity() const;
  /// Root mean square distance to the fitted line.
  double rms() const;

 private:
  CellPoint mean() const { return sum_ / weight_; }
  Eigen::Matrix2d scatter() const;  // divided by the weight

  CellPoint origin_;
  double weight_ = 0;
  CellPoint sum_ = CellPoint::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

}  // namespace opal::grid_importer
