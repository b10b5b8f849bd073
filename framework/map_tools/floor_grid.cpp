#include "map_tools/floor_grid.hpp"

#include "map_tools/map_raster.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace opal {
namespace {

constexpr float kDiagonal = 1.4142135f;

struct Step {
  int column, row;
  float length;  ///< in cells
};
// clang-format off
constexpr std::array<Step, 8> kSteps{{{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1},
                                      {1, 1, kDiagonal}, {1, -1, kDiagonal}, {-1, 1, kDiagonal}, {-1, -1, kDiagonal}}};
// clang-format on

/// A cell that a search will look at.
struct Open {
  float cost;
  int cell;
  bool operator>(const Open& other) const { return cost != other.cost ? cost > other.cost : cell > other.cell; }
};
using Queue = std::priority_queue<Open, std::vector<Open>, std::greater<Open>>;

}  // namespace

FloorGrid::FloorGrid(const Point& low, double cell_m, int columns, int rows, std::vector<char> free, Parts parts)
    : low_(low), cell_m_(cell_m), columns_(columns), rows_(rows), clearance_m_(free.size(), 0.f) {
  const auto at_border = [&](int cell) {
    const int column = cell % columns_, row = cell / columns_;
    return column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_;
  };
  for (int cell = 0; cell < columns_ * rows_; ++cell)
    if (free[cell] && !at_border(cell)) clearance_m_[cell] = 1;
  keep_parts(parts);
  measure_clearance();
}

int FloorGrid::cell_at(const Point& p) const {
  const Point cells = (p - low_) / cell_m_;
  if (!(cells.x() >= 0 && cells.y() >= 0 && cells.x() < columns_ && cells.y() < rows_)) return -1;
  return static_cast<int>(cells.y()) * columns_ + static_cast<int>(cells.x());
}

Point FloorGrid::center_of(int cell) const {
  const int column = cell % columns_, row = cell / columns_;
  return low_ + cell_m_ * Point(column + 0.5, row + 0.5);
}

/// By whole numbers: a step of one cell from a point on a border may end in the next cell but one.
template <class Visit>
void FloorGrid::visit_around(const Point& p, int reach, const Visit& visit) const {
  const Point cells = ((p - low_) / cell_m_).array().floor();
  if (!(cells.minCoeff() >= -reach && cells.x() < columns_ + reach && cells.y() < rows_ + reach)) return;
  const int column = static_cast<int>(cells.x()), row = static_cast<int>(cells.y());
  for (int j = std::max(0, row - reach); j <= std::min(rows_ - 1, row + reach); ++j)
    for (int i = std::max(0, column - reach); i <= std::min(columns_ - 1, column + reach); ++i) visit(j * columns_ + i);
}

void FloorGrid::keep_parts(Parts parts) {
  constexpr double kLeast_m2 = 1;
  std::vector<char> seen(clearance_m_.size(), 0);
  for (int start = 0; start < columns_ * rows_; ++start) {
    if (seen[start] || clearance_m_[start] == 0) continue;
    std::vector<int> part{start};
    seen[start] = 1;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (int n = 0; n < 4; ++n) {
        const int next = part[k] + kSteps[n].row * columns_ + kSteps[n].column;  // the border is not free
        if (seen[next] || clearance_m_[next] == 0) continue;
        seen[next] = 1;
        part.push_back(next);
      }
    const double part_m2 = cell_m_ * cell_m_ * static_cast<double>(part.size());
    if (parts == Parts::all && part_m2 >= kLeast_m2) free_.insert(free_.end(), part.begin(), part.end());
    if (parts == Parts::largest && part.size() > free_.size()) free_ = std::move(part);
  }
  std::fill(clearance_m_.begin(), clearance_m_.end(), 0.f);
  for (int cell : free_) clearance_m_[cell] = 1;
}

/// Dijkstra's distances from all cells that are not free, up to where more does not matter.
void FloorGrid::measure_clearance() {
  constexpr float kMost_m = 1;
  std::vector<float> distance(clearance_m_.size(), kMost_m);
  Queue queue;
  for (int cell = 0; cell < columns_ * rows_; ++cell)
    if (clearance_m_[cell] == 0) {
      distance[cell] = 0;
      queue.push({0, cell});
    }
  while (!queue.empty()) {
    const Open open = queue.top();
    queue.pop();
    if (open.cost > distance[open.cell]) continue;
    for (const Step& step : kSteps) {
      const int column = open.cell % columns_ + step.column, row = open.cell / columns_ + step.row;
      if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
      const int next = row * columns_ + column;
      const float cost = open.cost + step.length * static_cast<float>(cell_m_);
      if (cost >= distance[next]) continue;
      distance[next] = cost;
      queue.push({cost, next});
    }
  }
  for (int cell : free_) clearance_m_[cell] = distance[cell];
}

bool FloorGrid::holds(const Point& p) const {
  const int cell = cell_at(p);
  return cell >= 0 && clearance_m_[cell] > 0;
}

bool FloorGrid::holds(const Point& from, const Point& to) const {
  const int steps = 1 + static_cast<int>((to - from).norm() / (0.5 * cell_m_));
  for (int k = 0; k <= steps; ++k)
    if (!holds(Point(from + (to - from) * (static_cast<double>(k) / steps)))) return false;
  return true;
}

std::vector<std::array<Point, 2>> FloorGrid::rectangles() const {
  std::vector<std::array<Point, 2>> runs;
  int before = -2;
  for (int cell = 0; cell < columns_ * rows_; ++cell) {
    if (clearance_m_[cell] == 0) continue;
    const Point half = Point::Constant(cell_m_ / 2), center = center_of(cell);
    if (cell != before + 1)  // cells at the border are not free, so that a run ends with its row
      runs.push_back({center - half, center + half});
    else
      runs.back()[1] = center + half;
    before = cell;
  }
  return runs;
}

std::optional<Point> FloorGrid::nearest(const Point& p) const {
  if (holds(p)) return p;
  const int reach = static_cast<int>(0.5 / cell_m_ + 1e-9);
  std::optional<Point> best;
  visit_around(p, reach, [&](int cell) {
    if (clearance_m_[cell] == 0) return;
    const Point center = center_of(cell);
    if (!best || (center - p).norm() < (*best - p).norm()) best = center;
  });
  return best;
}

template <class Visit>
void FloorGrid::visit_near(std::span<const Point> points, double radius_m, const Visit& visit) const {
  const int reach = static_cast<int>(std::ceil(radius_m / cell_m_));
  for (const Point& point : points)
    visit_around(point, reach, [&](int cell) {
      if ((center_of(cell) - point).squaredNorm() < radius_m * radius_m) visit(cell);
    });
}

void FloorGrid::raise(Surcharge& prices, std::span<const Point> points, double radius_m, float price) const {
  visit_near(points, radius_m, [&](int cell) { prices[cell] = std::max(prices[cell], price); });
}

void FloorGrid::limit(Surcharge& prices, std::span<const Point> points, double radius_m, float price) const {
  visit_near(points, radius_m, [&](int cell) { prices[cell] = std::min(prices[cell], price); });
}

bool FloorGrid::is_outside(const Point& p) const {
  const int cell = cell_at(p);
  return cell >= 0 && is_outside(cell);
}

/// Of walking over a cell, per length.
float FloorGrid::price(int cell, const Surcharge& surcharge) const {
  constexpr float kWanted_m = 0.4f, kPrice = 3;  // walking along a wall costs up to four times the distance
  constexpr float kOutside = 20;
  return 1 + kPrice * std::max(0.f, 1 - clearance_m_[cell] / kWanted_m) + (surcharge.empty() ? 0 : surcharge[cell]) +
         (is_outside(cell) ? kOutside : 0);
}

FloorWays FloorGrid::search(int start, int goal, const Surcharge& surcharge) const {
  const bool begins_inside = !is_outside(start);
  const auto left = [&](int cell) {
    if (goal < 0) return 0.f;
    const int columns = cell % columns_ - goal % columns_, rows = cell / columns_ - goal / columns_;
    return std::hypot(static_cast<float>(columns), static_cast<float>(rows));
  };
  FloorWays ways{start, std::vector<float>(clearance_m_.size(), std::numeric_limits<float>::infinity()),
                 std::vector<int>(clearance_m_.size(), -1)};
  Queue queue;
  ways.cost[start] = 0;
  queue.push({left(start), start});
  while (!queue.empty() && queue.top().cell != goal) {
    const Open open = queue.top();
    queue.pop();
    if (open.cost > ways.cost[open.cell] + left(open.cell) + 1e-3f) continue;
    for (const Step& step : kSteps) {
      const int next = open.cell + step.row * columns_ + step.column;  // the border is not free
      if (clearance_m_[next] == 0 || (begins_inside && is_outside(next))) continue;
      const float further = ways.cost[open.cell] + step.length * price(next, surcharge);
      if (further >= ways.cost[next]) continue;
      ways.cost[next] = further;
      ways.before[next] = open.cell;
      queue.push({further + left(next), next});
    }
  }
  return ways;
}

std::optional<std::vector<Point>> FloorGrid::way(const Point& from, const Point& to, const Surcharge& surcharge) const {
  const auto first = nearest(from), last = nearest(to);
  if (!first || !last) return std::nullopt;
  const int start = cell_at(*first), goal = cell_at(*last);
  const FloorWays ways = search(start, goal, surcharge);
  if (goal != start && ways.before[goal] < 0) return std::nullopt;
  std::vector<Point> way{to};
  for (int cell = ways.before[goal]; cell >= 0 && cell != start; cell = ways.before[cell])
    way.push_back(center_of(cell));
  way.push_back(from);
  std::reverse(way.begin(), way.end());
  return way;
}

std::optional<FloorWays> FloorGrid::ways(const Point& from, const Surcharge& surcharge) const {
  const auto first = nearest(from);
  if (!first) return std::nullopt;
  return search(cell_at(*first), -1, surcharge);
}

double FloorGrid::line_cost(const Point& from, const Point& to, const Surcharge& surcharge) const {
  const double length_m = (to - from).norm();
  const int steps = 1 + static_cast<int>(length_m / (0.5 * cell_m_));
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const int cell = cell_at(from + (k + 0.5) / steps * (to - from));
    if (cell < 0 || clearance_m_[cell] == 0) return std::numeric_limits<double>::infinity();
    sum += price(cell, surcharge);
  }
  return length_m * sum / steps;
}

std::vector<Point> FloorGrid::straightened(const std::vector<Point>& way, const Surcharge& surcharge) const {
  constexpr std::size_t kMost = 60;  // points that one line stands for
  constexpr double kSame = 1.001;
  std::vector<Point> straight;
  for (std::size_t at = 0; at < way.size();) {
    straight.push_back(way[at]);
    std::size_t next = at + 1;
    double cost = 0;
    for (std::size_t k = at + 1; k < way.size() && k <= at + kMost; ++k) {
      cost += line_cost(way[k - 1], way[k], surcharge);
      if (line_cost(way[at], way[k], surcharge) <= kSame * cost) next = k;
    }
    at = next;
  }
  return straight;
}

std::vector<Point> FloorGrid::along(const FloorWays& ways, int cell) const {
  std::vector<Point> way;
  for (; cell >= 0; cell = ways.before[cell]) way.push_back(center_of(cell));
  std::reverse(way.begin(), way.end());
  return way;
}

MapRaster floor_raster(const SemanticMap& map) {
  RasterOptions options;
  options.resolution_m = 0.1;
  options.doors_open = true;
  return rasterized(map, options);
}

FloorGrid seen_floor(const MapRaster& raster, const std::function<bool(const Point&)>& has_room,
                     FloorGrid::Parts parts) {
  std::vector<char> free(raster.cells.size(), 0);
  for (int cell = 0; cell < raster.columns * raster.rows; ++cell) {
    const int column = cell % raster.columns, row = cell / raster.columns;
    const Point center = raster.origin + raster.resolution_m * Point(column + 0.5, row + 0.5);
    free[cell] = raster.cells[cell] == MapRaster::Cell::free && has_room(center);
  }
  return {raster.origin, raster.resolution_m, raster.columns, raster.rows, std::move(free), parts};
}

FloorGrid seen_floor(const SemanticMap& map, const std::function<bool(const Point&)>& has_room) {
  return seen_floor(floor_raster(map), has_room);
}

}  // namespace opal
