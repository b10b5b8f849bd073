#include "blur.hpp"

#include "boundary.hpp"

#include <algorithm>
#include <cmath>

namespace opal::grid_importer {
namespace {

constexpr double kWidestStrip_m = 0.5;
/// Grids with sharp borders have less, for beams that are far apart leave strips, too.
constexpr double kBlurred = 0.25;

/// The cells that one passes in a direction, as steps from where one starts.
using Way = std::vector<Cell>;

/// In all directions, as far as over the widest strip.
std::vector<Way> all_ways(const OccupancyGrid& grid) {
  const int widest = std::max(1, static_cast<int>(std::lround(grid.to_cells(kWidestStrip_m))));
  std::vector<Way> ways(DirectionSet::kSectors);
  for (int sector = 0; sector < DirectionSet::kSectors; ++sector)
    for (int k = 1; k <= widest + 1; ++k)
      ways[static_cast<std::size_t>(sector)].push_back(cell_at(k * DirectionSet::direction_of(sector)));
  return ways;
}

/// From a free cell across unknown ones: how many steps to an occupied cell; 0 if there is none within the strip.
std::size_t steps_across(const OccupancyGrid& grid, const Cell& from, const Way& way) {
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Occupancy there = grid.at(moved(from, way[k]));
    if (there == Occupancy::occupied) return k + 1;
    if (there == Occupancy::free) return 0;
  }
  return 0;
}

/// Visits (free cell, way, steps) wherever free space reaches an occupied cell.
template <class Visit>
void for_each_border(const OccupancyGrid& grid, Visit&& visit) {
  const std::vector<Way> ways = all_ways(grid);
  Cell c;
  for (c.row = 0; c.row < grid.rows(); ++c.row)
    for (c.column = 0; c.column < grid.columns(); ++c.column) {
      if (grid.at(c) != Occupancy::free) continue;
      for (const Way& way : ways)
        if (const std::size_t steps = steps_across(grid, c, way)) visit(c, way, steps);
    }
}

}  // namespace

double blurred_share(const OccupancyGrid& grid) {
  enum : std::uint8_t { none, across, directly };
  std::vector<std::uint8_t> reached(grid.cells().size(), none);
  for_each_border(grid, [&](const Cell& c, const Way& way, std::size_t steps) {
    std::uint8_t& there = reached[grid.index_of(moved(c, way[steps - 1]))];
    there = std::max<std::uint8_t>(there, steps == 1 ? directly : across);
  });
  const auto blurred = std::count(reached.begin(), reached.end(), across);
  const auto all = blurred + std::count(reached.begin(), reached.end(), directly);
  return all == 0 ? 0 : static_cast<double>(blurred) / static_cast<double>(all);
}

OccupancyGrid sharpened(const OccupancyGrid& grid) {
  if (blurred_share(grid) < kBlurred) return grid;
  OccupancyGrid result = grid;
  for_each_border(grid, [&](const Cell& c, const Way& way, std::size_t steps) {
    for (std::size_t k = 0; k + 1 < steps; ++k) result.set(moved(c, way[k]), Occupancy::free);
  });
  return result;
}

}  // namespace opal::grid_importer
