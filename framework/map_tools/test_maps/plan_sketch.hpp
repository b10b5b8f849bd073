#pragma once

#include "map_tools/map_raster.hpp"

#include <cstdint>

namespace opal {

/// How a plan of a building comes about that was drawn by hand, or printed and scanned.
struct PlanSketch {
  double resolution_m = 0.05;  ///< side of a cell of the picture
  double pen_m = 0.08;         ///< width of a line
  bool single_lines = true;    ///< a wall is one line along its middle; else a line for each face
  double wobble_m = 0.04;      ///< one sigma by which each end of a line is off, in x and in y
  double scale_sigma = 0.01;   ///< one sigma by which an axis is too long or too short, each by itself
  double turn_sigma_rad = 0;   ///< one sigma by which the plan is turned about its middle,
  double skew_sigma_rad = 0;   ///< and by which its axes are not at right angles
  double furniture = 4;        ///< outlines of furniture per 100 m2 of floor
  double words = 2;            ///< names and numbers per 100 m2 of floor
  double blur_m = 0;           ///< one sigma by which the paper is blurred before ink is told from paper
  double dirt = 0;             ///< share of the cells in which ink and paper are mixed up, before it is blurred
  std::uint64_t seed = 1;      ///< the same seed gives the same plan
};

/// Walls as single lines, doors as leaves with their arcs, furniture and words, by a hand that is not steady.
PlanSketch drawn_by_hand();
/// Both faces of walls, and the rest as above: on paper that a scanner has turned, stretched, blurred and soiled.
PlanSketch printed_and_scanned();

/// The picture of a plan: ink is occupied, and all paper is free, also inside of walls and outdoors. Its frame is that
/// of the map, as far as the plan is true to scale. Where the map has no doors, gaps as wide as one get a leaf.
/// @throws ConfigError if a number makes no sense. @throws MapError if nothing on the map has a surface.
OPAL_EXPORT MapRaster sketched(const SemanticMap& map, const PlanSketch& sketch);

}  // namespace opal
