#pragma once

#include "simulation/floor.hpp"

#include <array>

namespace opal::simulation {

/// Someone who walks about a building: two legs at the height of the laser.
class Walker {
 public:
  Walker(const Floor& floor, Random random);
  /// Goes on for a while. Whoever comes close to the robot turns round and goes elsewhere.
  void walk(double duration_s, const Floor& floor, const Circle& robot);
  const Point& position() const { return position_; }
  std::array<Circle, 2> legs() const;

 private:
  void choose_way(const Floor& floor);
  void step(double length_m);
  double nearest_foot_m(const Point& p) const;
  bool turns_away_from(const Point& p) const;

  Random random_;
  double speed_mps_;
  Point position_, direction_ = Point::UnitX();
  double stride_rad_ = 0;
  std::vector<Point> way_;  ///< what is left of it, last point first
  double pause_s_ = 0;
};

}  // namespace opal::simulation
