#include "boundary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opal::grid_importer {
namespace {

// A cell counts as seen from a direction if free space lies there 0.1 to 0.2 m away: near enough for narrow gaps,
// far enough that holes inside a dotted or smeared wall do not count as free space.
constexpr std::array<double, 3> kLookDistances_m{0.10, 0.15, 0.20};
constexpr int kFreeLooks = 2;

Cell moved(const Cell& from, const CellPoint& by) {
  return {from.column + static_cast<int>(std::lround(by.x())), from.row + static_cast<int>(std::lround(by.y()))};
}

bool touches_free(const OccupancyGrid& grid, const Cell& c) {
  for (int row = c.row - 1; row <= c.row + 1; ++row)
    for (int column = c.column - 1; column <= c.column + 1; ++column)
      if (grid.at({column, row}) == Occupancy::free) return true;
  return false;
}

bool is_seen_from(const OccupancyGrid& grid, const Cell& cell, int sector) {
  int free_looks = 0;
  for (const double distance_m : kLookDistances_m) {
    const double distance = std::max(1.0, grid.to_cells(distance_m));
    free_looks += grid.at(moved(cell, distance * DirectionSet::direction_of(sector))) == Occupancy::free;
  }
  return free_looks >= kFreeLooks;
}

DirectionSet visible_directions(const OccupancyGrid& grid, const Cell& cell) {
  DirectionSet visible;
  for (int sector = 0; sector < DirectionSet::kSectors; ++sector)
    if (is_seen_from(grid, cell, sector)) visible.add(sector);
  return visible;
}

}  // namespace

int DirectionSet::sector_of(const CellPoint& direction) {
  const double turns = std::atan2(direction.y(), direction.x()) / (2 * std::numbers::pi);
  return static_cast<int>(std::lround(turns * kSectors) + kSectors) % kSectors;
}

CellPoint DirectionSet::direction_of(int sector) {
  static const auto kTable = [] {
    std::array<CellPoint, kSectors> table;
    for (int k = 0; k < kSectors; ++k) table[static_cast<std::size_t>(k)] = unit_vector(2 * std::numbers::pi * k / kSectors);
    return table;
  }();
  return kTable[static_cast<std::size_t>(sector)];
}

void DirectionSet::add(int sector, int spread) {
  for (int k = -spread; k <= spread; ++k)
    bits_ = static_cast<std::uint16_t>(bits_ | 1U << (sector + k + kSectors) % kSectors);
}

Boundary::Boundary(const OccupancyGrid& grid) : grid_(grid), numbers_(grid.cells().size(), -1) {
  Cell c;
  for (c.row = 0; c.row < grid.rows(); ++c.row)
    for (c.column = 0; c.column < grid.columns(); ++c.column) {
      if (grid.cells()[grid.index_of(c)] != Occupancy::occupied || !touches_free(grid, c)) continue;
      numbers_[grid.index_of(c)] = size();
      cells_.push_back({c, visible_directions(grid, c), {}});
    }
}

}  // namespace opal::grid_importer
