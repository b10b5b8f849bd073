#pragma once

#include <opal/common/geometry.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace opal::simulation {

/// What a beam can meet: a straight piece, seen from both sides, or a round one.
struct Solid {
  Geometry shape = Segment{};  ///< a Segment or a Circle
  bool glass = false;
  bool open = false;  ///< of a door that is not where the map has it
};

/// Where the first solid on a beam's way is.
struct RayHit {
  double range_m = 0;
  int solid = -1;  ///< position in solids(); -1: nothing within reach
};

/// Casts rays among solids that stand still: exact, by a walk through a grid of 1 m cells (Amanatides and Woo 1987).
/// Frame: `map`.
class RayCaster {
 public:
  /// Shapes other than segments and circles, and those that are not finite, cannot be met.
  explicit RayCaster(std::vector<Solid> solids);

  const std::vector<Solid>& solids() const { return solids_; }
  /// @param direction  unit length.
  RayHit cast(const Point& origin, const Point& direction, double reach_m) const;
  /// Whatever stands on this side of `from`, e.g. glass that the beam went through, is not met.
  RayHit cast_beyond(const Point& origin, const Point& direction, double from_m, double reach_m) const;
  /// Position in solids() of one that a disc touches; -1: none.
  int touched(const Point& center, double radius_m) const;
  bool touches(const Point& center, double radius_m) const { return touched(center, radius_m) >= 0; }
  /// Smallest rectangle around all solids; zero if there is none.
  std::array<Point, 2> bounds() const { return {low_, high_}; }

 private:
  /// A solid ready for the inner loop.
  struct Prepared {
    double x, y;    ///< a segment's begin; a circle's centre
    double dx, dy;  ///< a segment's way from begin to end
    double radius;  ///< negative: a segment
  };

  using Cells = std::vector<std::vector<std::int32_t>>;
  void insert(int number, Cells& cells) const;
  int column_of(double x) const { return static_cast<int>((x - low_.x()) / kCell_m); }
  int row_of(double y) const { return static_cast<int>((y - low_.y()) / kCell_m); }
  std::span<const std::int32_t> in_cell(int column, int row) const;

  static constexpr double kCell_m = 1;
  std::vector<Solid> solids_;
  std::vector<Prepared> prepared_;
  Point low_ = Point::Zero(), high_ = Point::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> first_, entries_;  ///< entries of cell k: first_[k] to first_[k + 1]
};

}  // namespace opal::simulation
