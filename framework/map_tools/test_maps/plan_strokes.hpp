#pragma once

#include "common/random.hpp"

#include <opal/map/semantic_map.hpp>

#include <vector>

namespace opal {

/// One straight movement of a pen, frame `map`.
using Stroke = Segment;

/// The walls of a plan: a line for each face, or one along the middle of a wall whose two faces are mapped.
std::vector<Stroke> wall_strokes(const SemanticMap& map, bool single_lines);
/// The rims of columns.
std::vector<Stroke> column_strokes(const SemanticMap& map);
/// Leaves of doors that stand open at a right angle, each with the arc that it swings along. Where the map has no
/// doors, gaps as wide as one between faces along one line count as such.
std::vector<Stroke> door_strokes(const SemanticMap& map, Random& random);
/// Outlines of tables, cupboards and round things about these places.
std::vector<Stroke> furniture_strokes(const std::vector<Point>& places, Random& random);
/// Words that begin at these places: letters of a few strokes.
std::vector<Stroke> word_strokes(const std::vector<Point>& places, Random& random);

}  // namespace opal
