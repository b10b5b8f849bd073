#pragma once

#include <opal/common/geometry.hpp>

#include <array>
#include <vector>

/// Room that is surely empty: the outline of a scan's beams, shrunk. It may fall into several pieces. Frame: base_link
/// [m].
class FreeRoom {
 public:
  /// @param outline  not closed; simple but for rounding.
  /// @param margin_m  by which it is shrunk (a negative buffer).
  FreeRoom(const std::vector<opal::Point>& outline, double margin_m);

  /// The parts of a segment that lie inside, no less than depth_m from the edge in their middle.
  std::vector<opal::Segment> inside(const opal::Segment& segment, double depth_m) const;

 private:
  bool holds(const opal::Point& p) const;
  double depth_m(const opal::Point& p) const;

  std::vector<opal::Segment> edges_;
  std::array<opal::Point, 2> box_{opal::Point::Zero(), opal::Point::Zero()};
};
