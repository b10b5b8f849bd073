#pragma once

#include <opal/semantic_map.hpp>

#include <vector>

namespace opal::simulation {

class RayCaster;

/// Where a round robot can drive in a mapped building: the largest connected area, all doors open whose leaves no sensor
/// perceives, glass shut. Worked out on a grid from the map alone, so it serves any building. Frame: `map`.
class DrivableFloor {
 public:
  /// @throws MapError if the map has no face or circle that is perceived; ConfigError if a length is not positive, or the
  /// grid would have more than 10^8 cells.
  DrivableFloor(const SemanticMap& map, double radius_m, double cell_m = 0.1);

  /// Whether a robot can stand here, centre to the nearest cell, and drive to all other such places.
  bool can_stand(const Point& p) const;
  /// Centres of the cells where it can, row by row.
  std::vector<Point> places() const;

  double floor_m2() const;      ///< in front of some face, whether or not the robot gets there
  double covered_m2() const;    ///< that the robot's disc can cover, driving all over places()
  double covered_share() const { return covered_m2() / floor_m2(); }

 private:
  class Flood;
  void lay_out(const SemanticMap& map, const RayCaster& caster);
  void find_floor(const SemanticMap& map, const RayCaster& caster);
  void find_places(const RayCaster& caster, double radius_m);
  void cover(double radius_m);
  int cell_at(const Point& p) const;  ///< -1: outside
  int neighbour(int cell, int dx, int dy) const;
  Point centre(int cell) const;

  int columns_ = 0, rows_ = 0;
  double cell_m_ = 0;
  Point origin_ = Point::Zero();  ///< centre of the first cell
  std::vector<bool> is_floor_, can_stand_, is_covered_;
};

}  // namespace opal::simulation
