#pragma once

#include <opal/common/geometry.hpp>

#include <Eigen/Geometry>

#include <vector>

namespace opal::score_free_space {

/// Room that is surely empty: the outline of a scan's beams, shrunk. It may fall into several pieces. Frame: base_link
/// [m].
class FreeRoom {
 public:
  /// @param outline  not closed; simple but for rounding.
  /// @param margin_m  by which it is shrunk (a negative buffer).
  FreeRoom(const std::vector<Point>& outline, double margin_m);

  /// The parts of a segment that lie inside, no less than depth_m from the edge in their middle.
  std::vector<Segment> inside(const Segment& segment, double depth_m) const;

 private:
  bool holds(const Point& p) const;
  double depth_m(const Point& p) const;

  std::vector<Segment> edges_;
  Eigen::AlignedBox2d box_;
};

}  // namespace opal::score_free_space
