#include <opal/map_raster.hpp>

#include <opal/error.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace opal {
namespace {

constexpr double kMostCells = 1e8;
using Cell = MapRaster::Cell;

bool has_surface(const Geometry& geometry) {
  return std::holds_alternative<Segment>(geometry) || std::holds_alternative<Circle>(geometry);
}

/// Corners of what has a surface.
std::array<Point, 2> bounds_of(const SemanticMap& map) {
  std::optional<std::array<Point, 2>> box;
  const auto add = [&](const Point& p) {
    box = box ? std::array<Point, 2>{(*box)[0].cwiseMin(p), (*box)[1].cwiseMax(p)} : std::array<Point, 2>{p, p};
  };
  for (const MapFeature& feature : map.features()) {
    if (const auto* face = std::get_if<Segment>(&feature.geometry)) {
      add(face->begin);
      add(face->end);
    } else if (const auto* column = std::get_if<Circle>(&feature.geometry)) {
      add(column->center - Point::Constant(column->radius_m));
      add(column->center + Point::Constant(column->radius_m));
    }
  }
  if (!box) throw MapError(map.name() + ": no feature with a surface, expected a segment or a circle to draw");
  return *box;
}

class Rasterization {
 public:
  Rasterization(const SemanticMap& map, const RasterOptions& options) : map_(map) {
    const auto [min, max] = bounds_of(map);
    const Point size = (max - min + Point::Constant(2 * options.border_m)) / options.resolution_m;
    if (!(size.x() * size.y() < kMostCells))
      throw MapError(map.name() + ": a grid of " + std::to_string(size.x()) + " x " + std::to_string(size.y()) +
                     " cells, expected at most 10^8 in all");
    raster_.columns = static_cast<int>(std::ceil(size.x()));
    raster_.rows = static_cast<int>(std::ceil(size.y()));
    raster_.resolution_m = options.resolution_m;
    raster_.origin = min - Point::Constant(options.border_m);
    raster_.cells.assign(static_cast<std::size_t>(raster_.columns) * raster_.rows, Cell::unknown);
    nearest_.assign(raster_.cells.size(), -1);
  }

  MapRaster run() {
    for (std::size_t k = 0; k < map_.features().size(); ++k)
      if (has_surface(map_.features()[k].geometry)) draw(static_cast<int>(k));
    spread();
    return std::move(raster_);
  }

 private:
  Point centre(std::size_t index) const {
    const auto column = static_cast<double>(index % raster_.columns), row = static_cast<double>(index / raster_.columns);
    return raster_.origin + raster_.resolution_m * Point(column + 0.5, row + 0.5);
  }

  void occupy(const Point& p, int feature) {
    const Point cell = (p - raster_.origin) / raster_.resolution_m;
    const int column = static_cast<int>(std::floor(cell.x())), row = static_cast<int>(std::floor(cell.y()));
    if (column < 0 || row < 0 || column >= raster_.columns || row >= raster_.rows) return;
    const std::size_t index = static_cast<std::size_t>(row) * raster_.columns + column;
    if (raster_.cells[index] == Cell::occupied) return;
    raster_.cells[index] = Cell::occupied;
    nearest_[index] = feature;
    front_.push_back(index);
  }

  void draw(int feature) {
    const Geometry& geometry = map_.features()[feature].geometry;
    const double step_m = raster_.resolution_m / 2;
    if (const auto* face = std::get_if<Segment>(&geometry)) {
      const Point behind = -step_m * face->normal();
      for (double along = 0; along < face->length_m() + step_m; along += step_m)
        occupy(face->begin + std::min(along, face->length_m()) * face->direction() + behind, feature);
      return;
    }
    const auto& column = std::get<Circle>(geometry);
    for (double x = -column.radius_m; x <= column.radius_m; x += step_m)
      for (double y = -column.radius_m; y <= column.radius_m; y += step_m)
        if (std::hypot(x, y) <= column.radius_m) occupy(column.center + Point(x, y), feature);
  }

  bool sees(const Point& p, int feature) const {
    const auto* face = std::get_if<Segment>(&map_.features()[feature].geometry);
    return !face || (p - face->begin).dot(face->normal()) > 0;
  }

  /// From the surfaces outwards: every cell takes over the nearest surface of the neighbour that reaches it first.
  void spread() {
    while (!front_.empty()) {
      const std::size_t index = front_.front();
      front_.pop_front();
      const int feature = nearest_[index], column = static_cast<int>(index % raster_.columns);
      if (column > 0) reach(index - 1, feature);
      if (column + 1 < raster_.columns) reach(index + 1, feature);
      if (index >= static_cast<std::size_t>(raster_.columns)) reach(index - raster_.columns, feature);
      if (index + raster_.columns < nearest_.size()) reach(index + raster_.columns, feature);
    }
  }

  void reach(std::size_t index, int feature) {
    if (nearest_[index] >= 0) return;
    nearest_[index] = feature;
    if (sees(centre(index), feature)) raster_.cells[index] = Cell::free;
    front_.push_back(index);
  }

  const SemanticMap& map_;
  MapRaster raster_;
  std::vector<int> nearest_;  ///< feature whose surface is nearest
  std::deque<std::size_t> front_;
};

std::ofstream writable(const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  if (!file) throw Error(path + ": cannot be written");
  return file;
}

/// The brightness by which map_server knows them.
char brightness(Cell cell) {
  constexpr unsigned char kUnknown = 205, kFree = 254, kOccupied = 0;
  return static_cast<char>(cell == Cell::occupied ? kOccupied : cell == Cell::free ? kFree : kUnknown);
}

}  // namespace

MapRaster::Cell MapRaster::at(const Point& p) const {
  const Point cell = (p - origin) / resolution_m;
  const bool inside = cell.x() >= 0 && cell.y() >= 0 && cell.x() < columns && cell.y() < rows;
  return inside ? at(static_cast<int>(cell.x()), static_cast<int>(cell.y())) : Cell::unknown;
}

MapRaster rasterized(const SemanticMap& map, const RasterOptions& options) {
  if (!(options.resolution_m >= 1e-3 && options.resolution_m <= 10))
    throw ConfigError("raster: resolution " + std::to_string(options.resolution_m) + " m, expected 0.001 to 10");
  if (!(options.border_m >= 0 && options.border_m <= 1000))
    throw ConfigError("raster: border " + std::to_string(options.border_m) + " m, expected 0 to 1000");
  return Rasterization(map, options).run();
}

void write_raster(const MapRaster& raster, const std::string& yaml_path) {
  const std::filesystem::path yaml(yaml_path), image = std::filesystem::path(yaml).replace_extension(".pgm");
  auto pixels = writable(image.string());
  pixels << "P5\n" << raster.columns << ' ' << raster.rows << "\n255\n";
  for (int row = raster.rows - 1; row >= 0; --row)
    for (int column = 0; column < raster.columns; ++column) pixels.put(brightness(raster.at(column, row)));
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(10);
  text << "image: " << image.filename().string() << "\nresolution: " << raster.resolution_m << "\norigin: ["
       << raster.origin.x() << ", " << raster.origin.y()
       << ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  writable(yaml.string()) << text.str();
  if (!pixels.flush()) throw Error(image.string() + ": cannot be written");
}

}  // namespace opal
