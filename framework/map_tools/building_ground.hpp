#pragma once

#include "map_tools/floor_grid.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace opal {

/// The longest piece of a door's leaf; none: the object has no leaf.
OPAL_EXPORT std::optional<Segment> leaf_of(const SemanticMap& map, const MapObject& object);

/// The ground of a building as its map has it, in cells of 0.1 m: the one answer to where robots can be, for simulated
/// drives, for plans and for pictures. Doors inside stand open. Outer doors lead nowhere. Frame: `map`.
class OPAL_EXPORT BuildingGround {
 public:
  /// @param outdoors  robots can be outdoors, too, and outer doors are doors like others.
  /// @throws MapError if nothing on the map has a surface.
  explicit BuildingGround(const SemanticMap& map, bool outdoors = false);

  /// Where the building does not surround a robot (outside_cells), though a robot may not be there. False beyond the
  /// raster of the map.
  bool is_outside(const Point& p) const;
  /// Whether a door's leaf has the outside on one side, and robots have to stay inside.
  bool is_shut_outer_door(const SemanticMap& map, const MapObject& object) const;

  /// Ground with room, and none of it outside.
  /// @param has_room  at the centre of a cell.
  FloorGrid floor(const std::function<bool(const Point&)>& has_room,
                  FloorGrid::Parts parts = FloorGrid::Parts::largest) const;
  /// All ground with room. No way leads outside; a robot that is there by mistake finds in (FloorGrid::close_off).
  FloorGrid floor_with_outside(const std::function<bool(const Point&)>& has_room) const;

 private:
  MapRaster raster_;
  std::vector<char> outside_;  ///< by cell
};

}  // namespace opal
