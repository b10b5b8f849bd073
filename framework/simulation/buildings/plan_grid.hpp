#pragma once

#include "simulation/buildings/floor_plan.hpp"

#include <vector>

namespace opal::simulation {

/// A floor plan as cells between all the lines that any of its strokes has: exact, and no larger than it must be.
/// Everything around it is solid wall.
class PlanGrid {
 public:
  explicit PlanGrid(const FloorPlan& plan);

  /// The last stroke on a cell; those outside are wall.
  struct Cell {
    FloorPlan::Ground ground = FloorPlan::Ground::solid;
    int thing = FloorPlan::kWall;
    int space = FloorPlan::kNoSpace;
  };
  int columns() const { return static_cast<int>(xs_.size()) - 1; }
  int rows() const { return static_cast<int>(ys_.size()) - 1; }
  const Cell& at(int column, int row) const;
  bool is_floor(int column, int row) const { return at(column, row).ground == FloorPlan::Ground::floor; }
  /// Place of a line between cells [cm].
  int x(int column) const { return xs_[static_cast<std::size_t>(column)]; }
  int y(int row) const { return ys_[static_cast<std::size_t>(row)]; }

 private:
  void paint(const FloorPlan::Stroke& stroke);

  std::vector<int> xs_, ys_;
  std::vector<Cell> cells_;  // row by row
};

}  // namespace opal::simulation
