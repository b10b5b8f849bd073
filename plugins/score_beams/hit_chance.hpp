#pragma once

#include "map_cells.hpp"

#include <opal/map/view/map_view.hpp>

#include <vector>

/// How surprising it is that a beam ends on a mapped surface. In a drawing full of stair treads, window frames and
/// furniture, beams end on some line wherever the robot is believed to be.
class HitChance {
 public:
  /// @param reach_m  width of the strip along a surface in which a beam's end counts as a hit.
  HitChance(const opal::MapView& map, double reach_m);

  /// What a hit at a point of the map is worth, in (0, 1]: the logarithm of its chance, and 1 where no more is drawn
  /// than in rooms between walls. The chance is the share of the surroundings, 3 m x 3 m, within reach of a face that
  /// looks towards the robot; half of all faces do.
  double surprise(const opal::Point& p) const;

 private:
  double reach_m_;
  MapCells cells_;
  std::vector<float> faces_per_m_;  ///< by cell: length of the faces in it and around it, per area [m / m2]
};
