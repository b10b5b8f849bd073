#include "likelihood_field.hpp"

#include <algorithm>
#include <cmath>

LikelihoodField::LikelihoodField(const mrpt::maps::COccupancyGridMap2D& grid, const LikelihoodFieldOptions& options)
    : options_(options),
      x_min_(grid.getXMin()),
      y_min_(grid.getYMin()),
      resolution_m_(grid.getResolution()),
      columns_(static_cast<int>(grid.getSizeX())),
      rows_(static_cast<int>(grid.getSizeY())) {
  std::vector<float> nearest_m(static_cast<std::size_t>(columns_) * rows_, static_cast<float>(options.farthest_m));
  const int reach = static_cast<int>(options.farthest_m / resolution_m_);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      if (grid.getCell(column, row) > 0.35f) continue;  // the probability that it is free
      for (int j = std::max(0, row - reach); j <= std::min(rows_ - 1, row + reach); ++j)
        for (int i = std::max(0, column - reach); i <= std::min(columns_ - 1, column + reach); ++i) {
          float& nearest = nearest_m[static_cast<std::size_t>(j) * columns_ + i];
          nearest = std::min(nearest, static_cast<float>(resolution_m_ * std::hypot(i - column, j - row)));
        }
    }
  const auto likelihood = [&](double off_m) {
    return options.z_hit * std::exp(-off_m * off_m / (2 * options.sigma_hit_m * options.sigma_hit_m)) +
           options.z_rand / options.range_max_m;
  };
  for (const float off_m : nearest_m) likelihood_.push_back(static_cast<float>(likelihood(off_m)));
  far_ = likelihood(options.farthest_m);
}

void LikelihoodField::take(const std::vector<double>& ranges_m, const opal::LaserModel& laser) {
  ends_.clear();
  const int count = static_cast<int>(ranges_m.size());
  const int step = std::max(1, (count - 1) / (options_.beams - 1));
  for (int beam = 0; beam < count; beam += step) {
    const double range_m = ranges_m[static_cast<std::size_t>(beam)];
    if (!(range_m > 0) || range_m >= std::min(options_.range_max_m, laser.no_return_m)) continue;
    ends_.push_back(range_m * opal::unit_vector(laser.angle_min_rad + beam * laser.angle_increment_rad));
  }
}

double LikelihoodField::likelihood_at(double x, double y) const {
  const int column = static_cast<int>(std::floor((x - x_min_) / resolution_m_)),
            row = static_cast<int>(std::floor((y - y_min_) / resolution_m_));
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return far_;
  return likelihood_[static_cast<std::size_t>(row) * columns_ + column];
}

double LikelihoodField::log_weight(double x, double y, double heading_rad) const {
  const double c = std::cos(heading_rad), s = std::sin(heading_rad);
  double weight = 1;
  for (const opal::Point& end : ends_) {
    const double p = likelihood_at(x + c * end.x() - s * end.y(), y + s * end.x() + c * end.y());
    weight += p * p * p;
  }
  return std::log(weight);
}
