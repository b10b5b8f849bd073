#include "map_tools/map_raster.hpp"

#include <opal/common/error.hpp>
#include "common/geometry_box.hpp"
#include "common/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <ostream>
#include <sstream>

namespace opal {
namespace {

constexpr double kMostCells = 1e8;
using Cell = MapRaster::Cell;

bool has_surface(const Geometry& geometry) {
  return std::holds_alternative<Segment>(geometry) || std::holds_alternative<Circle>(geometry);
}

/// Of what has a surface.
Eigen::AlignedBox2d extent_of(const SemanticMap& map) {
  Eigen::AlignedBox2d box;
  for (const MapFeature& feature : map.features())
    if (has_surface(feature.geometry)) box.extend(box_of(feature.geometry));
  if (box.isEmpty()) throw MapError(map.name() + ": no feature with a surface, expected a segment or a circle to draw");
  return box;
}

/// In quotes wherever a program could read something else.
std::string yaml_text(const std::string& text) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.' || c == '-'; };
  if (std::ranges::all_of(text, is_plain) && !text.starts_with('-')) return text;
  std::string quoted = "'";
  for (const char c : text) quoted.append(c == '\'' ? 2 : 1, c);
  return quoted + "'";
}

class Rasterization {
 public:
  Rasterization(const SemanticMap& map, const RasterOptions& options) : map_(map), doors_open_(options.doors_open) {
    const Eigen::AlignedBox2d extent = extent_of(map);
    const Point size = (extent.sizes() + Point::Constant(2 * options.border_m)) / options.resolution_m;
    if (!(size.x() * size.y() < kMostCells))
      throw MapError(
          fmt::format("{}: a grid of {:f} x {:f} cells, expected at most 10^8 in all", map.name(), size.x(), size.y()));
    raster_.columns = static_cast<int>(std::ceil(size.x()));
    raster_.rows = static_cast<int>(std::ceil(size.y()));
    raster_.resolution_m = options.resolution_m;
    raster_.origin = extent.min() - Point::Constant(options.border_m);
    raster_.cells.assign(static_cast<std::size_t>(raster_.columns) * raster_.rows, Cell::unknown);
  }

  MapRaster run() {
    for (const MapFeature& feature : map_.features())
      if (stands(feature)) draw(feature.geometry);
    views_.assign(raster_.cells.size(), 0);
    for (const MapFeature& feature : map_.features())
      if (stands(feature)) look_from(feature.geometry);
    for (std::size_t cell = 0; cell < views_.size(); ++cell)
      if (views_[cell] > 0 && raster_.cells[cell] == Cell::unknown) raster_.cells[cell] = Cell::free;
    return std::move(raster_);
  }

 private:
  bool stands(const MapFeature& feature) const {
    return has_surface(feature.geometry) && !(doors_open_ && is_door_leaf(map_, feature));
  }

  void occupy(const Point& p) {
    if (const auto index = index_at(p)) raster_.cells[*index] = Cell::occupied;
  }

  void draw(const Geometry& geometry) {
    const double step_m = raster_.resolution_m / 2;
    if (const auto* face = std::get_if<Segment>(&geometry)) {
      const Point behind = -step_m * face->normal();
      for (double along = 0; along < face->length_m() + step_m; along += step_m)
        occupy(face->begin + std::min(along, face->length_m()) * face->direction() + behind);
      return;
    }
    const auto& column = std::get<Circle>(geometry);
    for (double x = -column.radius_m; x <= column.radius_m; x += step_m)
      for (double y = -column.radius_m; y <= column.radius_m; y += step_m)
        if (std::hypot(x, y) <= column.radius_m) occupy(column.center + Point(x, y));
  }

  // A third of fronts is enough: a room may have walls of which the map holds only the other side.
  static constexpr std::int32_t kFront = 2, kBack = -1;

  /// Tells all cells in view of a surface that they see its front, or its back.
  void look_from(const Geometry& geometry) {
    constexpr double kEvery_m = 0.5;
    if (const auto* face = std::get_if<Segment>(&geometry)) {
      const int looks = static_cast<int>(std::ceil(face->length_m() / kEvery_m));
      for (int k = 0; k < looks; ++k) {
        const Point from = face->begin + (k + 0.5) / looks * (face->end - face->begin);
        look_ahead(from, face->normal(), kFront);
        look_ahead(from, -face->normal(), kBack);
      }
      return;
    }
    const auto& column = std::get<Circle>(geometry);
    for (int turn = 0; turn < 12; ++turn) {
      const Point away = unit_vector(turn * std::numbers::pi / 6);
      look_ahead(column.center + (column.radius_m + raster_.resolution_m) * away, away, kFront);
    }
  }

  void look_ahead(const Point& from, const Point& ahead, std::int32_t counts) {
    constexpr double kStep_rad = 0.01;
    const double straight_rad = std::atan2(ahead.y(), ahead.x());
    for (double off_rad = -1.55; off_rad <= 1.55; off_rad += kStep_rad)
      look_along(from, unit_vector(straight_rad + off_rad), counts);
  }

  void look_along(const Point& from, const Point& direction, std::int32_t counts) {
    constexpr double kView_m = 15;
    const double step_m = raster_.resolution_m / 2;
    bool leaves_line = true;  // a wall that is drawn as one line stands in the cells on both sides of it
    for (double range_m = step_m; range_m < kView_m; range_m += step_m) {
      const auto index = index_at(from + range_m * direction);
      if (!index) return;
      const bool occupied = raster_.cells[*index] == Cell::occupied;
      if (occupied && leaves_line && range_m < 2 * raster_.resolution_m) continue;
      if (occupied) return;
      leaves_line = false;
      views_[*index] += counts;
    }
  }

  std::optional<std::size_t> index_at(const Point& p) const {
    const Point cell = (p - raster_.origin) / raster_.resolution_m;
    const bool inside = cell.x() >= 0 && cell.y() >= 0 && cell.x() < raster_.columns && cell.y() < raster_.rows;
    if (!inside) return std::nullopt;
    return static_cast<std::size_t>(static_cast<int>(cell.y())) * raster_.columns + static_cast<int>(cell.x());
  }

  const SemanticMap& map_;
  bool doors_open_;
  MapRaster raster_;
  std::vector<std::int32_t> views_;  ///< by cell: what is seen from there, summed up
};

/// The brightness by which map_server knows them.
char brightness(Cell cell) {
  constexpr unsigned char kUnknown = 205, kFree = 254, kOccupied = 0;
  return static_cast<char>(cell == Cell::occupied ? kOccupied : cell == Cell::free ? kFree : kUnknown);
}

void write_pixels(const MapRaster& raster, std::ostream& out) {
  out << "P5\n" << raster.columns << ' ' << raster.rows << "\n255\n";
  for (int row = raster.rows - 1; row >= 0; --row)
    for (int column = 0; column < raster.columns; ++column) out.put(brightness(raster.at(column, row)));
}

}  // namespace

bool is_door_leaf(const SemanticMap& map, const MapFeature& feature) {
  return feature.sensor.empty() && feature.object.exists() && map.object(feature.object).type == "opal:Door";
}

MapRaster::Cell MapRaster::at(const Point& p) const {
  const Point cell = (p - origin) / resolution_m;
  const bool inside = cell.x() >= 0 && cell.y() >= 0 && cell.x() < columns && cell.y() < rows;
  return inside ? at(static_cast<int>(cell.x()), static_cast<int>(cell.y())) : Cell::unknown;
}

MapRaster rasterized(const SemanticMap& map, const RasterOptions& options) {
  if (!(options.resolution_m >= 1e-3 && options.resolution_m <= 10))
    throw ConfigError(fmt::format("raster: resolution {:f} m, expected 0.001 to 10", options.resolution_m));
  if (!(options.border_m >= 0 && options.border_m <= 1000))
    throw ConfigError(fmt::format("raster: border {:f} m, expected 0 to 1000", options.border_m));
  return Rasterization(map, options).run();
}

void write_raster(const MapRaster& raster, const std::string& yaml_path) {
  const std::filesystem::path yaml(yaml_path), image = std::filesystem::path(yaml).replace_extension(".pgm");
  write_with(image.string(), [&](std::ostream& pixels) { write_pixels(raster, pixels); });
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(10);
  text << "image: " << yaml_text(image.filename().string()) << "\nresolution: " << raster.resolution_m << "\norigin: ["
       << raster.origin.x() << ", " << raster.origin.y()
       << ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  write_text(yaml.string(), text.str());
}

}  // namespace opal
