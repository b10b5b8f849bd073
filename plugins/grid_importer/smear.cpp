#include "smear.hpp"

#include "boundary.hpp"
#include "distance_transform.hpp"

#include <algorithm>
#include <cmath>

namespace opal::grid_importer {
namespace {

constexpr double kCoarse_m = 0.1;
constexpr float kRounding = 0.01f;  // cells

/// Strokes are one or two cells wide without any smear.
constexpr double kCleanStroke_m = 0.05;
/// Less is noise of a scan matcher, and every grid has it.
constexpr double kLeast_m = 0.15;
/// Walls that are thick in the building do not count: the thinnest strokes tell.
constexpr double kThinShare = 0.25;
/// Of the middle lines of strokes; less tells nothing: a few thick pillars are a few thick pillars.
constexpr double kEnough_m = 10;
/// Of strokes that were seen from one side only.
constexpr double kMiddle = 0.25;

/// Visits all cells.
template <class Visit>
void for_each_cell(const OccupancyGrid& grid, Visit&& visit) {
  Cell c;
  for (c.row = 0; c.row < grid.rows(); ++c.row)
    for (c.column = 0; c.column < grid.columns(); ++c.column) visit(c);
}

OccupancyGrid grown(const OccupancyGrid& grid, double by_cells) {
  OccupancyGrid result = grid;
  const std::vector<float> distance = distance_to_occupied(grid);
  for_each_cell(grid, [&](const Cell& c) {
    if (distance[grid.index_of(c)] <= by_cells + kRounding) result.set(c, Occupancy::occupied);
  });
  return result;
}

OccupancyGrid coarsened(const OccupancyGrid& grid, int factor) {
  OccupancyGrid result((grid.columns() + factor - 1) / factor, (grid.rows() + factor - 1) / factor,
                       grid.resolution_m() * factor, grid.T_map_grid());
  for_each_cell(grid, [&](const Cell& c) {
    const Cell into{c.column / factor, c.row / factor};
    result.set(into, std::max(result.at(into), grid.at(c)));  // unknown < free < occupied
  });
  return result;
}

/// The middle line of a stroke: no neighbour is farther from its border.
bool is_ridge(const OccupancyGrid& grid, const std::vector<float>& depth, const Cell& c) {
  const float here = depth[grid.index_of(c)];
  for (int row = c.row - 1; row <= c.row + 1; ++row)
    for (int column = c.column - 1; column <= c.column + 1; ++column)
      if (grid.contains({column, row}) && depth[grid.index_of({column, row})] > here + kRounding) return false;
  return true;
}

/// From the centre of a stroke's first cell to that of its last, in cells, at a cell of its middle line: of two cells
/// beside each other, if a stroke is an even number of cells wide.
float stroke_width(const OccupancyGrid& grid, const std::vector<float>& depth, const Cell& c) {
  const float here = depth[grid.index_of(c)];
  int as_deep = 0;
  for (const Cell& next :
       {Cell{c.column - 1, c.row}, {c.column + 1, c.row}, {c.column, c.row - 1}, {c.column, c.row + 1}})
    as_deep += grid.contains(next) && depth[grid.index_of(next)] > here - kRounding;
  return 2 * (here - 1) + (as_deep > 2 ? 1 : 0);
}

/// Whether free space lies on one side of a stroke's middle and nothing that was ever seen on the other: what stands
/// there was marked by beams from one side.
bool is_seen_from_one_side(const OccupancyGrid& grid, const Cell& c, float depth) {
  CellPoint to_free = CellPoint::Zero(), to_unknown = CellPoint::Zero();
  const int farthest = static_cast<int>(std::ceil(depth)) + 2;
  for (int sector = 0; sector < DirectionSet::kSectors; ++sector) {
    const CellPoint direction = DirectionSet::direction_of(sector);
    for (int k = 1; k <= farthest; ++k) {
      const Occupancy there = grid.at(moved(c, cell_at(k * direction)));
      if (there == Occupancy::occupied) continue;
      (there == Occupancy::free ? to_free : to_unknown) += direction;
      break;
    }
  }
  return to_free.norm() > 1 && to_unknown.norm() > 1 && to_free.normalized().dot(to_unknown.normalized()) < -0.8;
}

/// What is nearest to a cell and not occupied, within `reach` cells; free space goes first.
Occupancy nearest_unoccupied(const OccupancyGrid& grid, const Cell& c, int reach) {
  int best = std::numeric_limits<int>::max();
  Occupancy found = Occupancy::unknown;
  for (int row = c.row - reach; row <= c.row + reach; ++row)
    for (int column = c.column - reach; column <= c.column + reach; ++column) {
      const Occupancy there = grid.at({column, row});
      if (there == Occupancy::occupied) continue;
      const int square = (row - c.row) * (row - c.row) + (column - c.column) * (column - c.column);
      if (square > best || (square == best && there == Occupancy::unknown)) continue;
      best = square;
      found = there;
    }
  return found;
}

/// A quantile of the widths of strokes [m]; 0 if there are too few.
double width_of(std::vector<float>& widths, double share, const OccupancyGrid& grid) {
  if (static_cast<double>(widths.size()) * grid.resolution_m() < kEnough_m) return 0;
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(widths.size() - 1));
  std::nth_element(widths.begin(), widths.begin() + k, widths.end());
  return widths[static_cast<std::size_t>(k)] * grid.resolution_m();
}

}  // namespace

OccupancyGrid smeared(const OccupancyGrid& grid, double smear_m) {
  const OccupancyGrid thick = grown(grid, grid.to_cells(smear_m / 2));
  const int factor = std::max(1, static_cast<int>(std::lround(grid.to_cells(kCoarse_m))));
  return factor > 1 ? coarsened(thick, factor) : thick;
}

double estimate_smear_m(const OccupancyGrid& grid) {
  const std::vector<float> depth = distance_to_unoccupied(grid);
  std::vector<float> widths, one_sided;
  for_each_cell(grid, [&](const Cell& c) {
    const float here = depth[grid.index_of(c)];
    if (here == 0 || !is_ridge(grid, depth, c)) return;
    widths.push_back(stroke_width(grid, depth, c));
    if (is_seen_from_one_side(grid, c, here)) one_sided.push_back(widths.back());
  });
  const double width_m = std::max(width_of(widths, kThinShare, grid), width_of(one_sided, kMiddle, grid));
  const double smear_m = width_m - std::max(0.0, kCleanStroke_m - grid.resolution_m() / 2);
  return smear_m >= kLeast_m ? smear_m : 0;
}

OccupancyGrid unsmeared(const OccupancyGrid& grid, double smear_m) {
  OccupancyGrid result = grid;
  const std::vector<float> depth = distance_to_unoccupied(grid);
  const double peel = grid.to_cells(smear_m / 2);
  const int reach = static_cast<int>(std::ceil(peel)) + 1;
  for_each_cell(grid, [&](const Cell& c) {
    const float here = depth[grid.index_of(c)];
    if (here == 0 || here > peel + kRounding || is_ridge(grid, depth, c)) return;
    result.set(c, nearest_unoccupied(grid, c, reach));
  });
  return result;
}

}  // namespace opal::grid_importer
