#include "blur.hpp"

#include "boundary.hpp"

#include <algorithm>
#include <cmath>

namespace opal::grid_importer {
namespace {

constexpr double kWidestStrip_m = 0.5;
/// Grids with sharp borders have less, for beams that are far apart leave strips, too.
constexpr double kBlurred = 0.25;

Cell stepped(const Cell& from, const CellPoint& direction, int steps) {
  return cell_at(centre_of(from) + steps * direction);
}

/// From a free cell across unknown ones: how many steps to an occupied cell; 0 if there is none within the strip.
int steps_across(const OccupancyGrid& grid, const Cell& from, const CellPoint& direction, int widest) {
  for (int k = 1; k <= widest + 1; ++k) {
    const Occupancy there = grid.at(stepped(from, direction, k));
    if (there == Occupancy::occupied) return k;
    if (there == Occupancy::free) return 0;
  }
  return 0;
}

/// Visits (free cell, direction, steps) wherever free space reaches an occupied cell.
template <class Visit>
void for_each_border(const OccupancyGrid& grid, Visit&& visit) {
  const int widest = std::max(1, static_cast<int>(std::lround(grid.to_cells(kWidestStrip_m))));
  Cell c;
  for (c.row = 0; c.row < grid.rows(); ++c.row)
    for (c.column = 0; c.column < grid.columns(); ++c.column) {
      if (grid.at(c) != Occupancy::free) continue;
      for (int sector = 0; sector < DirectionSet::kSectors; ++sector) {
        const CellPoint direction = DirectionSet::direction_of(sector);
        if (const int steps = steps_across(grid, c, direction, widest)) visit(c, direction, steps);
      }
    }
}

}  // namespace

double blurred_share(const OccupancyGrid& grid) {
  enum : std::uint8_t { none, across, directly };
  std::vector<std::uint8_t> reached(grid.cells().size(), none);
  for_each_border(grid, [&](const Cell& c, const CellPoint& direction, int steps) {
    std::uint8_t& there = reached[grid.index_of(stepped(c, direction, steps))];
    there = std::max<std::uint8_t>(there, steps == 1 ? directly : across);
  });
  const auto blurred = std::count(reached.begin(), reached.end(), across);
  const auto all = blurred + std::count(reached.begin(), reached.end(), directly);
  return all == 0 ? 0 : static_cast<double>(blurred) / static_cast<double>(all);
}

OccupancyGrid sharpened(const OccupancyGrid& grid) {
  if (blurred_share(grid) < kBlurred) return grid;
  OccupancyGrid result = grid;
  for_each_border(grid, [&](const Cell& c, const CellPoint& direction, int steps) {
    for (int k = 1; k < steps; ++k) result.set(stepped(c, direction, k), Occupancy::free);
  });
  return result;
}

}  // namespace opal::grid_importer
