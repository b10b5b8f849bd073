#pragma once

#include "area_walls.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal::geojson_importer {

/// A door or a passage, in the `map` frame.
struct Opening {
  std::string id;
  Segment line;        ///< where it is drawn; a point has no length
  double width_m = 0;  ///< of one that is drawn as a point

  bool is_point() const { return line.begin == line.end; }
};

/// Width of an opening as tags have it ("width", "door:width": "0.9", "90 cm"); none if they do not.
std::optional<double> width_m_of(const Feature& feature);

/// Through the middle of a ring, along its longest edge, as long as the ring is in that direction.
Segment line_through(const Ring& ring);

/// Thickness of a wall that is drawn as a line, as its tag `width` has it ("0.3", "30 cm"); none if it has none.
std::optional<double> wall_width_m_of(const Feature& feature);

/// Takes out of the walls what lies at openings: along a drawn line, or as wide as a door about a point. Walls count
/// that run the same way and are at most `thickness_m` away: a wall may be drawn by its two faces.
/// @return where each opening is in its wall; none if no wall is near it.
std::vector<std::optional<Segment>> cut_openings(const std::vector<Opening>& openings, double thickness_m,
                                                 std::vector<AreaWall>& walls);

}  // namespace opal::geojson_importer
