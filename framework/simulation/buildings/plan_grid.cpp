#include "simulation/buildings/plan_grid.hpp"

#include <algorithm>

namespace opal::simulation {
namespace {

void sort_out(std::vector<int>& lines) {
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
}

int position_of(const std::vector<int>& lines, int line) {
  return static_cast<int>(std::lower_bound(lines.begin(), lines.end(), line) - lines.begin());
}

}  // namespace

PlanGrid::PlanGrid(const FloorPlan& plan) {
  for (const FloorPlan::Stroke& stroke : plan.strokes()) {
    xs_.insert(xs_.end(), {stroke.box.left, stroke.box.right});
    ys_.insert(ys_.end(), {stroke.box.bottom, stroke.box.top});
  }
  sort_out(xs_);
  sort_out(ys_);
  if (xs_.size() < 2 || ys_.size() < 2) xs_ = ys_ = {0, 1};
  cells_.resize(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()));
  for (const FloorPlan::Stroke& stroke : plan.strokes()) paint(stroke);
}

void PlanGrid::paint(const FloorPlan::Stroke& stroke) {
  const int left = position_of(xs_, stroke.box.left), right = position_of(xs_, stroke.box.right);
  const int bottom = position_of(ys_, stroke.box.bottom), top = position_of(ys_, stroke.box.top);
  for (int row = bottom; row < top; ++row)
    for (int column = left; column < right; ++column)
      cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) + static_cast<std::size_t>(column)] = {
          stroke.ground, stroke.thing, stroke.space};
}

const PlanGrid::Cell& PlanGrid::at(int column, int row) const {
  static const Cell around;
  if (column < 0 || row < 0 || column >= columns() || row >= rows()) return around;
  return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) + static_cast<std::size_t>(column)];
}

}  // namespace opal::simulation
