#pragma once

#include <opal/common/geometry.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace opal::point_to_line {

/// A small piece of what the reference points outline: their mean in one cell, and the direction across the outline,
/// zero where it is not known (corners, clutter, single points).
struct Surfel {
  Point mean = Point::Zero();
  Point normal = Point::Zero();
  double normal_variance = 0;  ///< of its heading, where the cells about it tell it [rad^2]
  Point end = Point::Zero();   ///< along the outline, to where it ends in view; zero if it goes on to both sides
  /// Some of its points have a near neighbour; if not, they say little about where a surface is. Only known where the
  /// cells about it do not tell the direction.
  bool dense = false;
  int points = 0;
};

/// Surfels of a point set and, for every cell near one, which surfel is nearest. Built once per match.
class ReferenceGrid {
 public:
  static constexpr double kReach_m = 0.3;  ///< how far around a surfel it is found

  /// @param reference  points in order of bearing per scan, finite.
  explicit ReferenceGrid(std::span<const Point> reference);

  bool empty() const { return surfels_.empty(); }
  double cell_m() const { return cell_m_; }

  /// The surfel nearest to the middle of the cell that holds `point`; null farther than kReach_m from all.
  const Surfel* nearest(const Point& point) const {
    const int column = column_of(point.x()), row = row_of(point.y());
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return nullptr;
    const std::uint32_t surfel = surfel_of_[cell(column, row)];
    return surfel != kNone ? &surfels_[surfel] : nullptr;
  }

  int column_of(double x) const { return static_cast<int>(std::floor((x - origin_.x()) / cell_m_)); }
  int row_of(double y) const { return static_cast<int>(std::floor((y - origin_.y()) / cell_m_)); }

  struct Cell {
    int column, row;
  };
  static constexpr int kMostSums = 16;
  using Sums = Eigen::Array<float, kMostSums, 1>;
  /// Of all cells, `rows` rows on, how near the reference is to column + k * step: 1 on it, 0 from kReach_m on; for
  /// k < count, at most kMostSums. Sums from there on mean nothing.
  Sums sum_likelihood_field(std::span<const Cell> cells, int rows, int step, int count) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  static constexpr int kMostStep = 8;  ///< of sums that are read at a time
  static constexpr int kReadAhead = kMostSums * kMostStep;

  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  void lay_out(std::span<const Point> reference);
  void gather(std::span<const Point> reference);
  /// Adds the direction across the outline at reference[i], which lies in the surfel's cell.
  static void add_neighbours(Surfel& surfel, std::span<const Point> reference, std::size_t i);
  /// @param surfel  whose normal is still the sum over its points.
  static void set_normal_of_points(Surfel& surfel);
  /// Takes the direction across the surfels about this one, and to where they end. @return false if they do not lie
  /// along a line.
  bool take_normal_of_neighbours(Surfel& surfel) const;
  void spread(std::uint32_t surfel);
  template <int kSums>
  Sums sum_likelihood_field(std::span<const Cell> cells, int rows, int step, int count) const;
  Sums likelihood_field_cell_by_cell(int column, int row, int step, int count) const;

  Point origin_ = Point::Zero();
  double cell_m_ = 0.1;
  int columns_ = 0;
  int rows_ = 0;
  // By cell. Apart from each other, since a search reads nothing but likelihood-field score, along rows.
  std::vector<std::uint32_t> surfel_of_;
  std::vector<float> likelihood_field_;  ///< and kReadAhead more
  std::vector<Surfel> surfels_;
};

}  // namespace opal::point_to_line
