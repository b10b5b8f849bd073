#include "boundary.hpp"

#include "line_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opal::grid_importer {
namespace {

// A cell counts as seen from a direction if free space lies there 0.1 to 0.3 m away: far enough that holes inside a
// dotted or smeared wall do not count, and that a strip which no beam crossed in between does not hide it.
constexpr double kNearestLook_m = 0.10;
constexpr double kFarthestLook_m = 0.30;
constexpr int kFreeLooks = 2;
// Cells nearer than this, in cells, may be smear of the same surface.
constexpr double kFirstLook = 2;

// Dots of a dotted wall have no axis. Cells of a zigzag have axes that a line cutting through it only half agrees with.
constexpr double kAgreementUnknown = 0.7;
constexpr double kCosAgree = 0.966;     // 15 degrees
constexpr double kCosDisagree = 0.819;  // 35 degrees

// What makes a surface plainly straight around a cell.
constexpr double kAxisRadius_m = 0.25;
constexpr double kMinAxisCells = 5;
constexpr double kMinAxisLinearity = 0.85;

bool touches_free(const OccupancyGrid& grid, const Cell& c) {
  for (int row = c.row - 1; row <= c.row + 1; ++row)
    for (int column = c.column - 1; column <= c.column + 1; ++column)
      if (grid.at({column, row}) == Occupancy::free) return true;
  return false;
}

/// Inner cells of a thick wall have occupied ones in front; a cell of a surface has free ones around, or unknown ones
/// that no beam happened to cross on its way.
DirectionSet visible_directions(const OccupancyGrid& grid, const Cell& cell) {
  const bool is_outermost = touches_free(grid, cell);
  DirectionSet visible;
  for (int sector = 0; sector < DirectionSet::kSectors; ++sector) {
    const Cell in_front = moved(cell, cell_at(DirectionSet::direction_of(sector)));
    if ((is_outermost || grid.at(in_front) != Occupancy::occupied) && is_open(grid, cell, sector)) visible.add(sector);
  }
  return visible;
}

}  // namespace

bool is_open(const OccupancyGrid& grid, const Cell& cell, int sector) {
  const double nearest = grid.to_cells(kNearestLook_m) - 0.01;  // rounding must not decide
  const double farthest = std::max(grid.to_cells(kFarthestLook_m), kFreeLooks + 1.0);
  int free_looks = 0;
  for (double distance = kFirstLook; distance <= farthest; ++distance) {
    const Occupancy there = grid.at(moved(cell, cell_at(distance * DirectionSet::direction_of(sector))));
    if (there == Occupancy::occupied) break;
    free_looks += there == Occupancy::free && distance >= nearest;
  }
  return free_looks >= kFreeLooks;
}

int DirectionSet::sector_of(const CellPoint& direction) {
  const double turns = std::atan2(direction.y(), direction.x()) / (2 * std::numbers::pi);
  return static_cast<int>(std::lround(turns * kSectors) + kSectors) % kSectors;
}

CellPoint DirectionSet::direction_of(int sector) {
  static const auto kTable = [] {
    std::array<CellPoint, kSectors> table;
    for (int k = 0; k < kSectors; ++k)
      table[static_cast<std::size_t>(k)] = unit_vector(2 * std::numbers::pi * k / kSectors);
    return table;
  }();
  return kTable[static_cast<std::size_t>(sector)];
}

void DirectionSet::add(int sector, int spread) {
  for (int k = -spread; k <= spread; ++k)
    bits_ = static_cast<std::uint16_t>(bits_ | 1U << (sector + k + kSectors) % kSectors);
}

bool BoundaryCell::is_partly_unexplained() const {
  for (int sector = 0; sector < DirectionSet::kSectors; ++sector)
    if (visible.contains(sector) && !explained.contains(sector)) return true;
  return false;
}

double BoundaryCell::agreement(const CellPoint& tangent) const {
  if (axis.isZero()) return kAgreementUnknown;
  const double cosine = std::abs(axis.dot(tangent));
  return std::clamp((cosine - kCosDisagree) / (kCosAgree - kCosDisagree), 0.0, 1.0);
}

Boundary::Boundary(const OccupancyGrid& grid) : grid_(grid), numbers_(grid.cells().size(), -1) {
  Cell c;
  for (c.row = 0; c.row < grid.rows(); ++c.row)
    for (c.column = 0; c.column < grid.columns(); ++c.column) {
      if (grid.cells()[grid.index_of(c)] != Occupancy::occupied) continue;
      const DirectionSet visible = visible_directions(grid, c);
      if (visible.empty()) continue;
      numbers_[grid.index_of(c)] = size();
      cells_.push_back({c, visible, {}, CellPoint::Zero()});
    }
  for (BoundaryCell& cell : cells_) cell.axis = axis_at(cell.cell);
}

CellPoint Boundary::axis_at(const Cell& cell) const {
  LineFit fit(centre_of(cell));
  visit_near(cell, std::max(2, static_cast<int>(grid_.to_cells(kAxisRadius_m))),
             [&](int other) { fit.add(centre_of((*this)[other].cell)); });
  const bool is_straight = fit.weight() >= kMinAxisCells && fit.linearity() >= kMinAxisLinearity;
  return is_straight ? fit.line(CellPoint::UnitX()).tangent : CellPoint::Zero();
}

}  // namespace opal::grid_importer
