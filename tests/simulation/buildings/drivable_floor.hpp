#pragma once

#include <opal/map/semantic_map.hpp>

#include <vector>
#include "simulation/ray_caster.hpp"

/// Where a round robot can drive in a mapped building: the largest connected area, all doors open whose leaves no
/// sensor perceives, glass shut. Worked out on a fine grid from the map alone. Frame: `map`.
class DrivableFloor {
 public:
  DrivableFloor(const opal::SemanticMap& map, double radius_m, double cell_m);

  /// Whether a robot can stand here, centre to the nearest cell, and drive to all other such places.
  bool can_stand(const opal::Point& p) const;
  /// Centres of the cells where it can, row by row.
  std::vector<opal::Point> places() const;

  double floor_m2() const;    ///< in front of some face, whether or not the robot gets there
  double covered_m2() const;  ///< that the robot's disc can cover, driving all over places()
  double covered_share() const { return covered_m2() / floor_m2(); }

 private:
  class Flood;
  void lay_out(const opal::simulation::RayCaster& caster);
  void find_floor(const opal::SemanticMap& map, const opal::simulation::RayCaster& caster);
  void find_places(const opal::simulation::RayCaster& caster, double radius_m);
  void cover(double radius_m);
  bool is_surrounded(int cell) const;
  int cell_at(const opal::Point& p) const;  ///< -1: outside
  int neighbour(int cell, int dx, int dy) const;
  opal::Point centre(int cell) const;

  int columns_ = 0, rows_ = 0;
  double cell_m_ = 0;
  opal::Point origin_ = opal::Point::Zero();  ///< centre of the first cell
  std::vector<bool> is_floor_, can_stand_, is_covered_;
};
