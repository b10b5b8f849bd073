#pragma once

#include "common/random.hpp"
#include "simulation/ray_caster.hpp"

#include <opal/map/semantic_map.hpp>

#include <functional>
#include <vector>

namespace opal::simulation {

/// More of the walls cannot be asked to stand behind things: a robot sees some of its building.
constexpr double kMostAlongWalls = 0.95;

/// What stands in a building that its map does not hold, in pieces per 100 m2 of floor.
struct ClutterOptions {
  double level = 1;     ///< multiplies the numbers below
  double tables = 0.8;  ///< four thin legs each, and up to four chairs of four thinner ones
  double chairs = 0.8;
  double carts = 0.4;
  double bins = 0.6;         ///< round or square
  double couches = 0.5;      ///< along walls
  double cabinets = 0.4;     ///< along walls, long enough to be taken for one
  double lookalikes = 0.15;  ///< round things of the radius of the building's columns, or of 0.2 m
  double hidden_share = 0;   ///< of columns and wall ends behind a board; not multiplied
  double along_walls = 0;    ///< share of the walls that stand behind things, up to kMostAlongWalls; not multiplied
};

/// The building itself: every face and column; glass where no sensor perceives a window or a panel; doors as leaves
/// that are open (turned about one end, out of the way) or closed.
/// @param stays_shut  which doors are never open; may be empty.
std::vector<Solid> building_solids(const SemanticMap& map, double doors_open_share, Random& random,
                                   const std::function<bool(const MapObject&)>& stays_shut = {});

/// The features of objects that only the furnished one of two maps of a building has, known by their ids.
std::vector<Solid> furniture_solids(const SemanticMap& furnished, const SemanticMap& building);

/// Pieces on a floor of the given size. Those that stand freely stand at `somewhere`'s answers.
std::vector<std::vector<Solid>> clutter_pieces(const SemanticMap& map, double floor_m2, const ClutterOptions& options,
                                               const std::function<Point(Random&)>& somewhere, Random& random);

}  // namespace opal::simulation
