#pragma once

#include <opal/map/view/map_view.hpp>

#include <cstdint>
#include <vector>

namespace opal {

/// Ends of mapped faces by place, in square cells: a lookup costs the same however large the map is.
class FaceEnds {
 public:
  struct End {
    Point position;
    Point direction;  ///< of its face, unit
    int face = -1;    ///< feature number
    Tip tip = Tip::begin;
  };

  FaceEnds() = default;
  explicit FaceEnds(std::vector<End> ends);
  FaceEnd nearest(const Point& p, const Point& direction, Tip tip, const EndGate& gate) const;

 private:
  int column_of(double x_m) const;
  int row_of(double y_m) const;
  std::size_t cell_of(const Point& p) const;

  Point low_ = Point::Zero();  ///< corner of the first cell
  double cell_m_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<End> ends_;             ///< those of one cell together
  std::vector<std::uint32_t> first_;  ///< by cell, row after row, and one more: of its ends in ends_
};

}  // namespace opal
