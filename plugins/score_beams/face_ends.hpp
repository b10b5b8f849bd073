#pragma once

#include <opal/map/view/map_view.hpp>

#include <cstdint>
#include <vector>

namespace opal::score_beams {

/// Which of a face's two ends, seen with the visible side on the left of begin -> end.
enum class Tip { begin, end };

/// How far an end that was seen may be from the mapped one, along its face and across it, and how far the two faces may
/// be turned against each other. A wall that is not quite where the map says still ends where it ends: more across than
/// along.
struct EndGate {
  double along_m = 0.3, across_m = 0.4, angle_rad = 0.2;
};

/// An end of a mapped face.
struct FaceEnd;
using FaceEndNumber = Id<FaceEnd>;
struct FaceEnd {
  MapFeatureNumber face = {};  ///< none: there is no such end
  Tip tip = Tip::begin;
  double gates = 1;  ///< how far off, in the gate's semi-axes, 0 to 1

  /// No two ends of a map have the same.
  FaceEndNumber number() const { return FaceEndNumber(2 * face.number() + (tip == Tip::end ? 1 : 0)); }
};

/// Ends of mapped faces by place, in square cells: a lookup costs the same however large the map is. Only where a wall
/// stops is an end: where a face goes on as another one that looks to the same side, there is none.
class FaceEnds {
 public:
  struct End {
    Point position;
    Point direction;  ///< of its face, unit
    MapFeatureNumber face = {};
    Tip tip = Tip::begin;
  };

  FaceEnds() = default;
  explicit FaceEnds(std::vector<End> ends);
  /// Those of all faces that the map's sensor can perceive.
  static FaceEnds of(const MapView& map);
  /// The end of a mapped face that an end seen at `p` may be, the nearest one within the gate.
  /// @param direction  of the face that was seen, unit.
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

}  // namespace opal::score_beams
