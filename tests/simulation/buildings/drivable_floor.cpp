#include "drivable_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

using namespace opal;
using namespace opal::simulation;

namespace {

constexpr std::array<std::array<int, 2>, 4> kNeighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
constexpr double kBesideFace_m = 0.02;
// Faces stand at round numbers: no cell has its centre on one.
constexpr double kOffGrid = 0.37;

bool is_open_door(const SemanticMap& map, const MapFeature& feature) {
  return feature.sensor.empty() && map.object(feature.object).type == "opal:Door";
}

std::vector<Solid> standing_solids(const SemanticMap& map) {
  std::vector<Solid> solids;
  for (const MapFeature& feature : map.features())
    if (!is_open_door(map, feature)) solids.push_back({feature.geometry, feature.sensor.empty()});
  return solids;
}

}  // namespace

/// Spreads over cells, from one to the next where nothing stands between their centres.
class DrivableFloor::Flood {
 public:
  Flood(const DrivableFloor& floor, const RayCaster& caster) : floor_(floor), caster_(caster) {}

  /// Marks all cells that can be reached from the start, among the allowed ones. @return how many are new.
  template <class Allowed>
  int run(int start, std::vector<bool>& marked, const Allowed& allowed) {
    if (marked[static_cast<std::size_t>(start)] || !allowed(start)) return 0;
    int count = 0;
    std::vector<int> open{start};
    marked[static_cast<std::size_t>(start)] = true;
    while (!open.empty()) {
      const int cell = open.back();
      open.pop_back();
      ++count;
      for (const auto& [dx, dy] : kNeighbours) {
        const int next = floor_.neighbour(cell, dx, dy);
        if (next < 0 || marked[static_cast<std::size_t>(next)] || !allowed(next)) continue;
        if (caster_.cast(floor_.centre(cell), Point(dx, dy), floor_.cell_m_).solid >= 0) continue;
        marked[static_cast<std::size_t>(next)] = true;
        open.push_back(next);
      }
    }
    return count;
  }

 private:
  const DrivableFloor& floor_;
  const RayCaster& caster_;
};

DrivableFloor::DrivableFloor(const SemanticMap& map, double radius_m, double cell_m) : cell_m_(cell_m) {
  const RayCaster caster(standing_solids(map));
  lay_out(caster);
  find_floor(map, caster);
  find_places(caster, radius_m);
  cover(radius_m);
}

void DrivableFloor::lay_out(const RayCaster& caster) {
  const auto [low, high] = caster.bounds();
  const Point cells = ((high - low) / cell_m_).array().floor() + 1;
  columns_ = static_cast<int>(cells.x());
  rows_ = static_cast<int>(cells.y());
  origin_ = low.array() + kOffGrid * cell_m_;
  is_floor_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), false);
  can_stand_ = is_covered_ = is_floor_;
}

void DrivableFloor::find_floor(const SemanticMap& map, const RayCaster& caster) {
  Flood flood(*this, caster);
  for (const MapFeature& feature : map.features()) {
    const auto* face = std::get_if<Segment>(&feature.geometry);
    if (!face || feature.sensor.empty()) continue;
    const Point beside = face->midpoint() + kBesideFace_m * face->normal();
    const int cell = cell_at(beside);
    if (cell < 0) continue;
    const Point way = centre(cell) - beside;
    const double length_m = way.norm();
    if (length_m > 0 && caster.cast(beside, way / length_m, length_m).solid >= 0) continue;
    flood.run(cell, is_floor_, [](int) { return true; });
  }
}

void DrivableFloor::find_places(const RayCaster& caster, double radius_m) {
  const int cells = columns_ * rows_;
  std::vector<bool> has_room(is_floor_.size());
  for (int cell = 0; cell < cells; ++cell)
    has_room[static_cast<std::size_t>(cell)] =
        is_floor_[static_cast<std::size_t>(cell)] && !caster.touches(centre(cell), radius_m);
  const auto allowed = [&](int cell) { return has_room[static_cast<std::size_t>(cell)]; };
  Flood flood(*this, caster);
  std::vector<bool> marked(is_floor_.size());
  int largest = 0, start = -1;
  for (int cell = 0; cell < cells; ++cell)
    if (const int size = flood.run(cell, marked, allowed); size > largest) largest = size, start = cell;
  if (start >= 0) flood.run(start, can_stand_, allowed);
}

void DrivableFloor::cover(double radius_m) {
  const int reach = static_cast<int>(radius_m / cell_m_);
  std::vector<std::array<int, 2>> disc;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx)
      if (std::hypot(dx, dy) * cell_m_ <= radius_m) disc.push_back({dx, dy});
  is_covered_ = can_stand_;
  for (int cell = 0; cell < columns_ * rows_; ++cell) {
    if (!can_stand_[static_cast<std::size_t>(cell)] || is_surrounded(cell)) continue;
    for (const auto& [dx, dy] : disc)
      if (const int other = neighbour(cell, dx, dy); other >= 0) is_covered_[static_cast<std::size_t>(other)] = true;
  }
}

/// What the disc covers from such a cell, it covers from the neighbours, too.
bool DrivableFloor::is_surrounded(int cell) const {
  return std::all_of(kNeighbours.begin(), kNeighbours.end(), [&](const std::array<int, 2>& step) {
    const int next = neighbour(cell, step[0], step[1]);
    return next >= 0 && can_stand_[static_cast<std::size_t>(next)];
  });
}

int DrivableFloor::cell_at(const Point& p) const {
  const Point at = (p - origin_) / cell_m_;
  const int column = static_cast<int>(std::lround(at.x())), row = static_cast<int>(std::lround(at.y()));
  return column < 0 || row < 0 || column >= columns_ || row >= rows_ ? -1 : row * columns_ + column;
}

int DrivableFloor::neighbour(int cell, int dx, int dy) const {
  const int column = cell % columns_ + dx, row = cell / columns_ + dy;
  return column < 0 || row < 0 || column >= columns_ || row >= rows_ ? -1 : row * columns_ + column;
}

Point DrivableFloor::centre(int cell) const { return origin_ + cell_m_ * Point(cell % columns_, cell / columns_); }

bool DrivableFloor::can_stand(const Point& p) const {
  const int cell = cell_at(p);
  return cell >= 0 && can_stand_[static_cast<std::size_t>(cell)];
}

std::vector<Point> DrivableFloor::places() const {
  std::vector<Point> centres;
  for (int cell = 0; cell < columns_ * rows_; ++cell)
    if (can_stand_[static_cast<std::size_t>(cell)]) centres.push_back(centre(cell));
  return centres;
}

double DrivableFloor::floor_m2() const {
  return cell_m_ * cell_m_ * static_cast<double>(std::count(is_floor_.begin(), is_floor_.end(), true));
}

double DrivableFloor::covered_m2() const {
  return cell_m_ * cell_m_ * static_cast<double>(std::count(is_covered_.begin(), is_covered_.end(), true));
}
