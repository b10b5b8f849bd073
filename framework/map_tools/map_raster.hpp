#pragma once

#include <opal/map/semantic_map.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace opal {

/// A semantic map as a grid, for programs that know nothing else.
struct MapRaster {
  enum class Cell : std::uint8_t { unknown, free, occupied };

  int columns = 0;
  int rows = 0;
  double resolution_m = 0;       ///< side of a cell
  Point origin = Point::Zero();  ///< lower left corner of the first cell, frame `map`
  std::vector<Cell> cells;       ///< row by row, the lowest one first

  Cell at(int column, int row) const { return cells[static_cast<std::size_t>(row) * columns + column]; }
  /// The cell that a point of the map lies in; unknown outside.
  OPAL_EXPORT Cell at(const Point& p) const;
};

struct RasterOptions {
  double resolution_m = 0.05;
  double border_m = 1;      ///< around everything that is mapped
  bool doors_open = false;  ///< leaves of doors, which no sensor perceives, are not drawn
};

/// Whether a feature is of a door's leaf: a door's frame can be perceived, its leaf cannot.
OPAL_EXPORT bool is_door_leaf(const SemanticMap& map, const MapFeature& feature);

/// Cells just behind a face, and those of a round column, are occupied. Others are free if, of the surfaces that can be
/// seen from there, within 15 m, more than a third show their front, and unknown if not: what walls enclose that show
/// their backs is solid, also if it is seen through a gap.
/// @throws MapError if nothing on the map has a surface, or the grid would have more than 10^8 cells.
/// @throws ConfigError if a number makes no sense.
OPAL_EXPORT MapRaster rasterized(const SemanticMap& map, const RasterOptions& options = {});

/// Writes the yaml file of ROS map_server and, beside it, the image that it names (.pgm).
/// @throws Error naming the file if one cannot be written.
OPAL_EXPORT void write_raster(const MapRaster& raster, const std::string& yaml_path);

}  // namespace opal
