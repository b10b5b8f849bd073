#include "simulation/floor.hpp"

#include <opal/error.hpp>
#include <opal/map_raster.hpp>

#include <algorithm>
#include <array>
#include <queue>

namespace opal::simulation {
namespace {

constexpr float kDiagonal = 1.4142135f;

struct Step {
  int column, row;
  float length;  ///< in cells
};
constexpr std::array<Step, 8> kSteps{{{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1},
                                      {1, 1, kDiagonal}, {1, -1, kDiagonal}, {-1, 1, kDiagonal}, {-1, -1, kDiagonal}}};

/// A cell that a search will look at.
struct Open {
  float cost;
  int cell;
  bool operator>(const Open& other) const { return cost != other.cost ? cost > other.cost : cell > other.cell; }
};
using Queue = std::priority_queue<Open, std::vector<Open>, std::greater<Open>>;

}  // namespace

Floor::Floor(const SemanticMap& map, const RayCaster& solids, double radius_m) {
  RasterOptions options;
  options.resolution_m = kCell_m;
  const MapRaster raster = rasterized(map, options);
  low_ = raster.origin;
  columns_ = raster.columns;
  rows_ = raster.rows;
  clearance_m_.assign(raster.cells.size(), 0);
  const auto at_border = [&](int cell) {
    const int column = cell % columns_, row = cell / columns_;
    return column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_;
  };
  for (int cell = 0; cell < columns_ * rows_; ++cell)
    if (raster.cells[cell] == MapRaster::Cell::free && !at_border(cell) && !solids.touches(center_of(cell), radius_m)) clearance_m_[cell] = 1;
  keep_largest_part();
  if (free_.empty())
    throw MapError(map.name() + ": has no floor for a robot of " + std::to_string(radius_m) +
                   " m radius, expected a place from which mapped walls are seen");
  measure_clearance();
}

int Floor::index_of(const Point& p) const {
  const Point cells = (p - low_) / kCell_m;
  if (!(cells.x() >= 0 && cells.y() >= 0 && cells.x() < columns_ && cells.y() < rows_)) return -1;
  return static_cast<int>(cells.y()) * columns_ + static_cast<int>(cells.x());
}

Point Floor::center_of(int cell) const {
  return low_ + kCell_m * Point(cell % columns_ + 0.5, cell / columns_ + 0.5);
}

void Floor::keep_largest_part() {
  std::vector<char> seen(clearance_m_.size(), 0);
  for (int start = 0; start < columns_ * rows_; ++start) {
    if (seen[start] || clearance_m_[start] == 0) continue;
    std::vector<int> part{start};
    seen[start] = 1;
    for (std::size_t k = 0; k < part.size(); ++k)
      for (int n = 0; n < 4; ++n) {
        const int column = part[k] % columns_ + kSteps[n].column, row = part[k] / columns_ + kSteps[n].row;
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
        const int next = row * columns_ + column;
        if (seen[next] || clearance_m_[next] == 0) continue;
        seen[next] = 1;
        part.push_back(next);
      }
    if (part.size() > free_.size()) free_ = std::move(part);
  }
  std::fill(clearance_m_.begin(), clearance_m_.end(), 0.f);
  for (int cell : free_) clearance_m_[cell] = 1;
}

/// Dijkstra's distances from all cells that are not free, up to where more does not matter.
void Floor::measure_clearance() {
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
      const float cost = open.cost + step.length * static_cast<float>(kCell_m);
      if (cost >= distance[next]) continue;
      distance[next] = cost;
      queue.push({cost, next});
    }
  }
  for (int cell : free_) clearance_m_[cell] = distance[cell];
}

bool Floor::holds(const Point& p) const {
  const int cell = index_of(p);
  return cell >= 0 && clearance_m_[cell] > 0;
}

Point Floor::anywhere(Random& random) const { return center_of(free_[random.below(free_.size())]); }

std::optional<Point> Floor::nearest(const Point& p) const {
  if (holds(p)) return p;
  constexpr int kReach = 5;
  std::optional<Point> best;
  for (int j = -kReach; j <= kReach; ++j)
    for (int i = -kReach; i <= kReach; ++i) {
      const int cell = index_of(p + kCell_m * Point(i, j));
      if (cell < 0 || clearance_m_[cell] == 0) continue;
      const Point center = center_of(cell);
      if (!best || (center - p).norm() < (*best - p).norm()) best = center;
    }
  return best;
}

std::optional<std::vector<Point>> Floor::way(const Point& from, const Point& to) const {
  const auto first = nearest(from), last = nearest(to);
  if (!first || !last) return std::nullopt;
  const int start = index_of(*first), goal = index_of(*last);
  constexpr float kWanted_m = 0.4f, kPrice = 3;  // walking along a wall costs up to four times the distance
  const auto price = [&](int cell) { return 1 + kPrice * std::max(0.f, 1 - clearance_m_[cell] / kWanted_m); };
  const auto left = [&](int cell) {
    return std::hypot(static_cast<float>(cell % columns_ - goal % columns_), static_cast<float>(cell / columns_ - goal / columns_));
  };
  std::vector<float> cost(clearance_m_.size(), std::numeric_limits<float>::infinity());
  std::vector<int> before(clearance_m_.size(), -1);
  Queue queue;
  cost[start] = 0;
  queue.push({left(start), start});
  while (!queue.empty() && queue.top().cell != goal) {
    const Open open = queue.top();
    queue.pop();
    if (open.cost > cost[open.cell] + left(open.cell) + 1e-3f) continue;
    for (const Step& step : kSteps) {
      const int next = open.cell + step.row * columns_ + step.column;  // the border is not free
      if (clearance_m_[next] == 0) continue;
      const float further = cost[open.cell] + step.length * price(next);
      if (further >= cost[next]) continue;
      cost[next] = further;
      before[next] = open.cell;
      queue.push({further + left(next), next});
    }
  }
  std::vector<Point> way{to};
  for (int cell = before[goal]; cell >= 0 && cell != start; cell = before[cell]) way.push_back(center_of(cell));
  way.push_back(from);
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace opal::simulation
