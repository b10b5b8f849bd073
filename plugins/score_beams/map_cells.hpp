#pragma once

#include <opal/common/geometry.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

/// Square cells over a map, row after row. What lies outside is in the nearest one.
class MapCells {
 public:
  MapCells() = default;
  /// @param low, high  corners of what is covered [m]. @param cell_m  larger in a map so wide that there would be too
  /// many.
  MapCells(const opal::Point& low, const opal::Point& high, double cell_m) : low_(low) {
    constexpr double kMostCells = 1 << 22, kMostInARow = 1 << 20;
    const opal::Point size_m = high - low + opal::Point::Ones();
    cell_m_ = std::max({cell_m, std::sqrt(size_m.prod() / kMostCells), size_m.maxCoeff() / kMostInARow});
    columns_ = static_cast<int>(size_m.x() / cell_m_) + 1;
    rows_ = static_cast<int>(size_m.y() / cell_m_) + 1;
  }

  double cell_m() const { return cell_m_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t count() const { return static_cast<std::size_t>(columns_) * rows_; }

  int column_of(double x_m) const { return at(x_m - low_.x(), columns_); }
  int row_of(double y_m) const { return at(y_m - low_.y(), rows_); }
  std::size_t number(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }
  std::size_t cell_of(const opal::Point& p) const { return number(column_of(p.x()), row_of(p.y())); }

 private:
  int at(double offset_m, int cells) const {
    return static_cast<int>(std::clamp(std::floor(offset_m / cell_m_), 0.0, cells - 1.0));
  }

  opal::Point low_ = opal::Point::Zero();
  double cell_m_ = 1;
  int columns_ = 0, rows_ = 0;
};
