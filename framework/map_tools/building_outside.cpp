#include "map_tools/building_outside.hpp"

#include "map_tools/map_stack.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace opal {
namespace {

std::vector<Point> ends_of(const SemanticMap& map) {
  std::vector<Point> ends;
  for (const MapFeature& feature : map.features()) {
    if (const auto* face = std::get_if<Segment>(&feature.geometry)) ends.insert(ends.end(), {face->begin, face->end});
    if (const auto* column = std::get_if<Circle>(&feature.geometry)) ends.push_back(column->center);
  }
  return ends;
}

/// The convex hull of what is mapped, counter-clockwise (Andrew 1979).
std::vector<Point> hull_of(const SemanticMap& map) {
  std::vector<Point> ends = ends_of(map), hull;
  std::ranges::sort(ends,
                    [](const Point& a, const Point& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  for (int half = 0; half < 2; ++half, std::ranges::reverse(ends)) {
    const std::size_t first = hull.size();
    for (const Point& p : ends) {
      while (hull.size() >= first + 2 && cross(Point(hull.back() - hull[hull.size() - 2]), Point(p - hull.back())) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
  }
  return hull;
}

bool is_in(const std::vector<Point>& hull, const Point& p) {
  for (std::size_t k = 0; k < hull.size(); ++k)
    if (cross(Point(hull[(k + 1) % hull.size()] - hull[k]), Point(p - hull[k])) < 0) return false;
  return !hull.empty();
}

class OpenGround {
 public:
  OpenGround(const SemanticMap& map, const MapRaster& raster)
      : map_(map), raster_(raster), walls_(raster.cells.size(), 0), outside_(raster.cells.size(), 0) {
    for (const MapFeature& feature : map.features()) {
      if (const auto* face = std::get_if<Segment>(&feature.geometry)) draw(*face);
      if (const auto* column = std::get_if<Circle>(&feature.geometry)) draw(*column);
    }
  }

  std::vector<char> run() {
    measure_free();
    for (int column = 0; column < raster_.columns; ++column)
      for (const int row : {0, raster_.rows - 1}) enter(column, row);
    for (int row = 0; row < raster_.rows; ++row)
      for (const int column : {0, raster_.columns - 1}) enter(column, row);
    for (std::size_t k = 0; k < open_.size(); ++k) {
      const int column = open_[k] % raster_.columns, row = open_[k] / raster_.columns;
      for (const auto& [i, j] : std::array<std::array<int, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}})
        enter(column + i, row + j);
    }
    if (is_no_building())
      leave_hull(map_);
    else
      take_recesses();
    return std::move(outside_);
  }

 private:
  int cell_at(const Point& p) const {
    const Point cell = (p - raster_.origin) / raster_.resolution_m;
    const bool there = cell.x() >= 0 && cell.y() >= 0 && cell.x() < raster_.columns && cell.y() < raster_.rows;
    return there ? static_cast<int>(cell.y()) * raster_.columns + static_cast<int>(cell.x()) : -1;
  }

  void fill(const Point& p) {
    if (const int cell = cell_at(p); cell >= 0) walls_[cell] = 1;
  }

  /// Two cells thick, so that no ray slips through.
  void draw(const Segment& face) {
    const double step_m = raster_.resolution_m / 2;
    if (!(face.length_m() > 0)) return fill(face.begin);
    for (double along_m = 0; along_m < face.length_m() + step_m; along_m += step_m)
      for (const double off_m : {-step_m, step_m})
        fill(face.begin + std::min(along_m, face.length_m()) * face.direction() + off_m * face.normal());
  }

  void draw(const Circle& column) {
    const double step_rad = std::min(0.5, 0.5 * raster_.resolution_m / std::max(column.radius_m, 1e-3));
    for (double turn = 0; turn < 2 * std::numbers::pi; turn += step_rad)
      fill(column.center + column.radius_m * unit_vector(turn));
  }

  void enter(int column, int row) {
    if (column < 0 || row < 0 || column >= raster_.columns || row >= raster_.rows) return;
    const int cell = row * raster_.columns + column;
    if (outside_[cell] || walls_[cell] ||
        !is_open(raster_.origin + raster_.resolution_m * Point(column + 0.5, row + 0.5)))
      return;
    outside_[cell] = 1;
    open_.push_back(cell);
  }

  bool is_open(const Point& place) const {
    constexpr int kDirections = 18, kOpen = 6;
    int met_nothing = 0;
    for (int k = 0; k < kDirections && met_nothing < kOpen; ++k)
      met_nothing += meets_nothing(place, unit_vector(2 * std::numbers::pi * k / kDirections));
    return met_nothing >= kOpen;
  }

  bool meets_nothing(Point place, const Point& direction) const {
    constexpr double kStep = 0.7;  // cells
    const Point step = kStep * raster_.resolution_m * direction;
    for (int cell = cell_at(place); cell >= 0; cell = cell_at(place)) {
      if (walls_[cell]) return false;
      // No wall is nearer than that: what lies between is not looked up.
      place += std::max(1, static_cast<int>((free_around_[cell] - 1) / kStep)) * step;
    }
    return true;
  }

  /// Cells from each cell to the next wall, along rows, columns and diagonals (Rosenfeld and Pfaltz 1966).
  void measure_free() {
    free_around_.assign(walls_.size(), raster_.columns + raster_.rows);
    for (std::size_t cell = 0; cell < walls_.size(); ++cell)
      if (walls_[cell]) free_around_[cell] = 0;
    const int last = static_cast<int>(walls_.size()) - 1;
    for (int cell = 0; cell <= last; ++cell) lower(cell, -1);
    for (int cell = last; cell >= 0; --cell) lower(cell, 1);
  }

  /// By the neighbours that were visited before. @param side  -1: those of lower number; 1: of higher.
  void lower(int cell, int side) {
    const int column = cell % raster_.columns, row = cell / raster_.columns;
    const auto look = [&](int i, int j) {
      const int x = column + i, y = row + j;
      if (x < 0 || y < 0 || x >= raster_.columns || y >= raster_.rows) return;
      free_around_[cell] = std::min(free_around_[cell], free_around_[y * raster_.columns + x] + 1);
    };
    for (const int i : {-1, 0, 1}) look(i, side);
    look(side, 0);
  }

  int inside_cells() const {
    int inside = 0;
    for (std::size_t cell = 0; cell < outside_.size(); ++cell)
      inside += raster_.cells[cell] == MapRaster::Cell::free && !outside_[cell];
    return inside;
  }

  bool is_no_building() const { return 3 * inside_cells() < std::ranges::count(raster_.cells, MapRaster::Cell::free); }

  /// What the open leads into by no door, and what is hardly deeper than its mouth is wide: a porch, a carport.
  void take_recesses() {
    constexpr int kLeastShare = 5;  // a larger part than this of the building is the building
    std::vector<char> seen = outside_;
    const int inside = inside_cells();
    for (std::size_t k = 0; k < open_.size(); ++k)
      each_neighbour(open_[k], [&](int cell) {
        if (seen[cell] || walls_[cell]) return;
        const std::vector<int> ground = ground_from(cell, seen);
        if (kLeastShare * static_cast<int>(ground.size()) < inside && is_recess(ground))
          for (const int inner : ground) outside_[inner] = 1;
      });
  }

  std::vector<int> ground_from(int start, std::vector<char>& seen) const {
    std::vector<int> ground{start};
    seen[start] = 1;
    for (std::size_t k = 0; k < ground.size(); ++k)
      each_neighbour(ground[k], [&](int cell) {
        if (seen[cell] || walls_[cell]) return;
        seen[cell] = 1;
        ground.push_back(cell);
      });
    return ground;
  }

  bool is_recess(const std::vector<int>& ground) const {
    constexpr double kDepth = 2;
    double mouth = 0;
    for (const int cell : ground) {
      bool at_mouth = false;
      each_neighbour(cell, [&](int next) { at_mouth = at_mouth || outside_[next]; });
      mouth += at_mouth;
    }
    return static_cast<double>(ground.size()) < kDepth * mouth * mouth;
  }

  template <class Visit>
  void each_neighbour(int cell, const Visit& visit) const {
    const int column = cell % raster_.columns, row = cell / raster_.columns;
    if (column > 0) visit(cell - 1);
    if (row > 0) visit(cell - raster_.columns);
    if (column + 1 < raster_.columns) visit(cell + 1);
    if (row + 1 < raster_.rows) visit(cell + raster_.columns);
  }

  /// Where walls enclose nothing, what lies around everything mapped is outside.
  void leave_hull(const SemanticMap& map) {
    const std::vector<Point> hull = hull_of(map);
    for (std::size_t cell = 0; cell < outside_.size(); ++cell) {
      const int column = static_cast<int>(cell) % raster_.columns, row = static_cast<int>(cell) / raster_.columns;
      outside_[cell] = !is_in(hull, raster_.origin + raster_.resolution_m * Point(column + 0.5, row + 0.5));
    }
  }

  const SemanticMap& map_;
  const MapRaster& raster_;
  std::vector<char> walls_, outside_;
  std::vector<int> free_around_;
  std::vector<int> open_;  ///< outside, in the order in which they were found
};

/// A part of a raster, and where its first cell is in the whole.
struct RasterPart {
  MapRaster raster;
  int column = 0, row = 0;
};

/// Where a sheet of a map is, with the usual border.
RasterPart part_with(const SemanticMap& sheet, const MapRaster& raster) {
  Eigen::AlignedBox2d box;
  for (const Point& p : ends_of(sheet)) box.extend(p);
  if (box.isEmpty() || !box.min().allFinite()) return {};
  const double border_m = RasterOptions{}.border_m;
  const Point low = ((box.min() - raster.origin).array() - border_m).matrix() / raster.resolution_m,
              high = ((box.max() - raster.origin).array() + border_m).matrix() / raster.resolution_m;
  RasterPart part{{}, std::max(0, static_cast<int>(low.x())), std::max(0, static_cast<int>(low.y()))};
  MapRaster& cut = part.raster;
  cut.resolution_m = raster.resolution_m;
  cut.origin = raster.origin + raster.resolution_m * Point(part.column, part.row);
  cut.columns = std::min(raster.columns, static_cast<int>(std::ceil(high.x()))) - part.column;
  cut.rows = std::min(raster.rows, static_cast<int>(std::ceil(high.y()))) - part.row;
  for (int row = 0; row < cut.rows; ++row)
    for (int column = 0; column < cut.columns; ++column)
      cut.cells.push_back(raster.at(part.column + column, part.row + row));
  return part;
}

}  // namespace

std::vector<char> outside_cells(const SemanticMap& map, const MapRaster& raster) {
  if (map.origin().storeys.empty()) return OpenGround(map, raster).run();
  std::vector<char> outside(raster.cells.size(), 1);
  for (const MapStorey& storey : map.origin().storeys) {
    const auto sheet = storey_of_map(map, storey.id);
    const RasterPart part = part_with(*sheet, raster);
    const std::vector<char> on_sheet = OpenGround(*sheet, part.raster).run();
    for (int row = 0; row < part.raster.rows; ++row)
      std::copy_n(on_sheet.begin() + static_cast<std::ptrdiff_t>(row) * part.raster.columns, part.raster.columns,
                  outside.begin() + static_cast<std::ptrdiff_t>(part.row + row) * raster.columns + part.column);
  }
  return outside;
}

}  // namespace opal
