#pragma once

#include <opal/common/geometry.hpp>
#include <opal/map/semantic_map.hpp>

#include <optional>
#include <string>
#include <vector>

namespace opal::dxf_importer {

/// A line of a drawing that may be a part of a door, in the `map` frame.
struct DoorStroke {
  std::string id;             ///< of the door or the block
  bool is_door = false;       ///< its layer says so
  std::vector<Point> points;  ///< in order
};

/// The arc that a door leaf draws.
struct DoorSwing {
  Point hinge = Point::Zero();
  Point begin = Point::Zero(), end = Point::Zero();  ///< of the arc: the leaf's tip, open and closed
  double radius_m() const { return (begin - hinge).norm(); }
};

/// None if the points are no arc of 40 to 190 degrees.
std::optional<DoorSwing> swing_of(const std::vector<Point>& points);

/// Doors that stand on a wall which goes on under them, as where a door block masks the wall that is drawn through: the
/// wall closes them in the map. Things of other layers count where they have a leaf and its swing.
/// @return ids, each once, in order of the strokes.
std::vector<std::string> closed_doors(const std::vector<DoorStroke>& strokes, const SemanticMap& map);

}  // namespace opal::dxf_importer
