#pragma once

#include "simulation/random.hpp"
#include "simulation/ray_caster.hpp"

#include <opal/semantic_map.hpp>

#include <optional>
#include <vector>

namespace opal::simulation {

/// Where in a building one can be: cells of 0.1 m from which some mapped surface is seen on its visible side, less those
/// too near to something solid. Frame: `map`.
class Floor {
 public:
  static constexpr double kCell_m = 0.1;

  /// @param radius_m  of whoever wants to be there.
  /// @throws MapError if there is no such place.
  Floor(const SemanticMap& map, const RayCaster& solids, double radius_m);

  /// Whether p is in the largest connected part.
  bool holds(const Point& p) const;
  double area_m2() const { return kCell_m * kCell_m * static_cast<double>(free_.size()); }
  /// Some place on it.
  Point anywhere(Random& random) const;

  /// The place on it next to p, no farther than 0.5 m; p itself if it is on the floor.
  std::optional<Point> nearest(const Point& p) const;

  /// The way from one place to another, along cell centres, that keeps its distance from what is solid where it can
  /// (A*, Hart, Nilsson and Raphael 1968); the ends are those given. Nullopt if one of them is not on the floor, or next
  /// to it.
  std::optional<std::vector<Point>> way(const Point& from, const Point& to) const;

 private:
  int index_of(const Point& p) const;  ///< -1: outside the grid
  Point center_of(int cell) const;
  void measure_clearance();
  void keep_largest_part();

  Point low_ = Point::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<float> clearance_m_;  ///< from the nearest cell that is not free; 0: not free
  std::vector<int> free_;           ///< cells of the largest part
};

}  // namespace opal::simulation
