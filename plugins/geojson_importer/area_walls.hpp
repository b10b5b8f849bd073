#pragma once

#include "geojson_reader.hpp"

#include <string>
#include <vector>

namespace opal::geojson_importer {

/// A part of a floor, in the `map` frame.
struct Area {
  /// What stands around it.
  enum class Kind {
    room,      ///< walls on all sides
    corridor,  ///< walls, but not towards other corridors and open areas
    open       ///< nothing of its own
  };
  std::string id;
  Kind kind = Kind::room;
  std::vector<std::vector<Ring>> polygons;  ///< outer ring, holes
};

/// A straight piece of wall.
struct AreaWall {
  int element = 0;  ///< number of what it belongs to
  Segment line;
};

/// The walls that stand around areas; `element` is the number of the area. Two areas that share a border give two lines
/// at one place.
std::vector<AreaWall> walls_around(const std::vector<Area>& areas);

}  // namespace opal::geojson_importer
