#include "simulation/ray_caster.hpp"

#include "common/geometry_box.hpp"

#include <algorithm>
#include <limits>

namespace opal::simulation {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// From a solid and what it encloses.
double distance_from(const Geometry& shape, const Point& p) {
  if (const auto* circle = std::get_if<Circle>(&shape))
    return std::max(0.0, (p - circle->center).norm() - circle->radius_m);
  return distance_m(shape, p);
}

bool can_be_met(const Geometry& shape) {
  if (!std::holds_alternative<Segment>(shape) && !std::holds_alternative<Circle>(shape)) return false;
  const Eigen::AlignedBox2d box = box_of(shape);
  return box.min().allFinite() && box.max().allFinite();
}

double disc_range(const Point& origin, const Point& direction, double x, double y, double radius, double from_m) {
  const double px = x - origin.x(), py = y - origin.y();
  const double along = px * direction.x() + py * direction.y();
  const double half_square = radius * radius - (px * px + py * py - along * along);
  if (half_square < 0) return kNever;
  const double half = std::sqrt(half_square);
  if (along - half > from_m) return along - half;
  return along + half > from_m ? along + half : kNever;
}

double piece_range(const Point& origin, const Point& direction, double x, double y, double dx, double dy,
                   double from_m) {
  const double denominator = direction.x() * dy - direction.y() * dx;
  if (denominator == 0) return kNever;
  const double px = x - origin.x(), py = y - origin.y();
  const double share = (px * direction.y() - py * direction.x()) / denominator;
  if (!(share >= 0 && share <= 1)) return kNever;
  const double range = (px * dy - py * dx) / denominator;
  return range > from_m ? range : kNever;
}

}  // namespace

RayCaster::RayCaster(std::vector<Solid> solids) : solids_(std::move(solids)) {
  std::erase_if(solids_, [](const Solid& solid) { return !can_be_met(solid.shape); });
  if (solids_.empty()) return;
  Eigen::AlignedBox2d bounds;
  for (const Solid& solid : solids_) {
    bounds.extend(box_of(solid.shape));
    if (const auto* segment = std::get_if<Segment>(&solid.shape)) {
      const Point way = segment->end - segment->begin;
      prepared_.push_back({segment->begin.x(), segment->begin.y(), way.x(), way.y(), -1});
    } else {
      const auto& circle = std::get<Circle>(solid.shape);
      prepared_.push_back({circle.center.x(), circle.center.y(), 0, 0, circle.radius_m});
    }
  }
  low_ = bounds.min();
  high_ = bounds.max();
  columns_ = column_of(high_.x()) + 1;
  rows_ = row_of(high_.y()) + 1;
  Cells cells(static_cast<std::size_t>(columns_) * rows_);
  for (std::size_t k = 0; k < solids_.size(); ++k) insert(static_cast<int>(k), cells);
  first_.push_back(0);
  for (const auto& cell : cells) {
    entries_.insert(entries_.end(), cell.begin(), cell.end());
    first_.push_back(static_cast<std::int32_t>(entries_.size()));
  }
}

/// Into every cell of its bounding box that it comes near: a long diagonal wall must not fill the box.
void RayCaster::insert(int number, Cells& cells) const {
  constexpr double kReach_m = 0.7072 * kCell_m + 1e-9;  // half a cell's diagonal
  const Eigen::AlignedBox2d box = box_of(solids_[number].shape);
  for (int row = row_of(box.min().y()); row <= row_of(box.max().y()); ++row)
    for (int column = column_of(box.min().x()); column <= column_of(box.max().x()); ++column) {
      const Point center = low_ + kCell_m * Point(column + 0.5, row + 0.5);
      if (distance_from(solids_[number].shape, center) <= kReach_m)
        cells[static_cast<std::size_t>(row) * columns_ + column].push_back(number);
    }
}

std::span<const std::int32_t> RayCaster::in_cell(int column, int row) const {
  const std::size_t k = static_cast<std::size_t>(row) * columns_ + column;
  return {entries_.data() + first_[k], entries_.data() + first_[k + 1]};
}

RayHit RayCaster::cast(const Point& origin, const Point& direction, double reach_m) const {
  return cast_beyond(origin, direction, 0, reach_m);
}

RayHit RayCaster::cast_beyond(const Point& origin, const Point& direction, double from_m, double reach_m) const {
  if (solids_.empty() || !origin.allFinite() || !direction.allFinite()) return {};
  // Where the ray is inside the grid.
  double enter = std::max(from_m, 0.0), leave = reach_m;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = low_[axis] - 1e-9, high = low_[axis] + kCell_m * (axis == 0 ? columns_ : rows_);
    if (direction[axis] == 0) {
      if (origin[axis] < low || origin[axis] >= high) return {};
      continue;
    }
    const double a = (low - origin[axis]) / direction[axis], b = (high - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave) return {};
  const Point start = origin + enter * direction;
  int column = std::clamp(column_of(start.x()), 0, columns_ - 1), row = std::clamp(row_of(start.y()), 0, rows_ - 1);
  const int step_x = direction.x() < 0 ? -1 : 1, step_y = direction.y() < 0 ? -1 : 1;
  const double per_x = direction.x() == 0 ? kNever : kCell_m / std::abs(direction.x());
  const double per_y = direction.y() == 0 ? kNever : kCell_m / std::abs(direction.y());
  const auto border = [&](double low, int cell, int step) { return low + kCell_m * (cell + (step > 0)); };
  double next_x = direction.x() == 0 ? kNever : (border(low_.x(), column, step_x) - origin.x()) / direction.x();
  double next_y = direction.y() == 0 ? kNever : (border(low_.y(), row, step_y) - origin.y()) / direction.y();

  RayHit best{reach_m, -1};
  while (true) {
    for (const std::int32_t number : in_cell(column, row)) {
      const Prepared& solid = prepared_[number];
      const double range = solid.radius < 0
                               ? piece_range(origin, direction, solid.x, solid.y, solid.dx, solid.dy, from_m)
                               : disc_range(origin, direction, solid.x, solid.y, solid.radius, from_m);
      if (range < best.range_m) best = {range, number};
    }
    const double border_m = std::min(next_x, next_y);
    if (best.range_m <= border_m || border_m > leave) break;
    if (next_x < next_y) {
      column += step_x;
      next_x += per_x;
    } else {
      row += step_y;
      next_y += per_y;
    }
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) break;
  }
  return best.solid < 0 ? RayHit{} : best;
}

int RayCaster::touched(const Point& center, double radius_m) const {
  if (solids_.empty()) return -1;
  const int low_column = std::max(0, column_of(center.x() - radius_m)),
            low_row = std::max(0, row_of(center.y() - radius_m));
  const int high_column = std::min(columns_ - 1, column_of(center.x() + radius_m));
  const int high_row = std::min(rows_ - 1, row_of(center.y() + radius_m));
  for (int row = low_row; row <= high_row; ++row)
    for (int column = low_column; column <= high_column; ++column)
      for (const std::int32_t number : in_cell(column, row))
        if (distance_from(solids_[number].shape, center) <= radius_m) return number;
  return -1;
}

}  // namespace opal::simulation
