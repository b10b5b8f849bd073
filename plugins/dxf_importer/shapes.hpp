#pragma once

#include "block_expansion.hpp"

#include <opal/import_kit/plan_assembly.hpp>

#include <string>

namespace opal::dxf_importer {

/// How entities become lines and circles.
struct ShapeOptions {
  double metres_per_unit = 1;
  Point origin_m = Point::Zero();  ///< what lies here in the drawing is the map's origin
  double chord_tolerance_m = 0.005;
  double circle_tolerance_m = 0.003;
  double max_column_radius_m = 1;  ///< a larger circle is a curved wall
};

/// What entities of a drawing look like in the map, in the `map` frame.
struct Shapes {
  std::vector<PlanLine> lines;
  std::vector<Circle> circles;
  int refitted = 0;    ///< circles that were drawn as closed lines
  int chorded = 0;     ///< arcs and circles that are short straight lines now
  double width_m = 0;  ///< with which a polyline was drawn; 0: with none
};

/// @param closed_sides  what a closed line is the outline of.
/// @return what is wrong with the entity; empty if nothing is.
std::string add_shape(const PlacedEntity& placed, const ShapeOptions& options, PlanSides closed_sides, Shapes& shapes);

}  // namespace opal::dxf_importer
