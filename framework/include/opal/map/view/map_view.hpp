#pragma once

#include <opal/map/semantic_map.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <vector>

namespace opal {

using WallLineNumber = Id<struct WallLine>;  ///< of a straight line that faces lie on, or of a circle

/// A face or a round column, prepared for fast geometry: the numbers that every beam needs, computed once.
struct Surface {
  Point origin = Point::Zero();     ///< a face's begin; a circle's centre
  Point direction = Point::Zero();  ///< a face's unit direction, visible side on the left; zero for a circle
  double size_m = 0;                ///< a face's length; a circle's radius
  MapObjectNumber object = {};      ///< that it belongs to
  /// Faces that lie on one straight line, look to the same side and are at most 30 m apart share a number, however a
  /// map cuts them up; a circle has its own.
  WallLineNumber line = {};

  /// True for a round column, false for a face.
  bool is_circle() const { return direction.x() == 0 && direction.y() == 0; }
  /// Unit vector towards the visible side of a face; zero for a circle.
  Point normal() const { return left_of(direction); }
  /// Shortest distance from `p` to the face or the rim.
  double distance_m(const Point& p) const {
    const Point from = p - origin;
    if (is_circle()) return std::abs(from.norm() - size_m);
    return (from - std::clamp(direction.dot(from), 0.0, size_m) * direction).norm();
  }
};

/// What one sensor can perceive of a map, with indices that answer spatial questions in microseconds. Immutable and
/// shared. Frame: `map`.
class OPAL_EXPORT MapView {
 public:
  /// @param map      as a whole; other sensors' features included.
  /// @param sensor   id of the sensor.
  /// @param kept_in  folder in which what is prepared of a large map is kept for the next time: it is mapped into
  ///                 memory then, and what nobody looks at takes none. Empty: it is in memory, and kept nowhere.
  /// @throws ConfigError if the map holds nothing that this sensor can perceive.
  MapView(std::shared_ptr<const SemanticMap> map, const std::string& sensor, const std::string& kept_in = {});
  ~MapView();
  MapView(const MapView&) = delete;
  MapView& operator=(const MapView&) = delete;

  const SemanticMap& map() const;                            ///< the whole map, other sensors' features included
  const std::string& kept_in() const;                        ///< folder of what is prepared; empty: there is none
  const MapFeature& feature(MapFeatureNumber number) const;  ///< perceivable or not
  /// All perceivable features.
  std::span<const MapFeatureNumber> features() const;
  /// The surface of a feature that is a segment or a circle.
  const Surface& surface(MapFeatureNumber number) const;
  /// Features with some point within radius_m of p, in no order (R-tree, exact).
  std::vector<MapFeatureNumber> within(const Point& p, double radius_m) const;

  /// The surface (segment or circle) nearest to `p` that faces a viewer who looks along `view_direction`, among those
  /// within reach_m(). A lookup in a grid of 0.1 m cells, so a surface up to one cell farther may be named.
  /// @param p               where the surface is looked for [m].
  /// @param view_direction  any length; from the viewer to p.
  /// @return its feature; none if there is no surface.
  MapFeatureNumber nearest_facing(const Point& p, const Point& view_direction) const;
  /// Distance [m] from p to the nearest surface whatever its side, by grid lookup (within one cell's diagonal), capped
  /// at clearance_cap_m().
  double clearance_m(const Point& p) const;
  /// How far `nearest_facing` looks from a point.
  static constexpr double reach_m() { return 0.8; }
  /// The largest answer of `clearance_m`.
  static constexpr double clearance_cap_m() { return 2.5; }
  /// Width of a cell in the grids that lookups use.
  static constexpr double cell_m() { return 0.1; }

  /// exp(-d^2 / (2 * 0.2^2)) of the distance d to the nearest surface, by grid lookup: for coarse, fast judgements.
  float likelihood_field(const Point& p) const;
  /// Sum of the likelihood-field score of `position + point`, over all points.
  /// @param points    relative to `position` [m], along the axes of the map.
  /// @param position  in the map [m].
  /// @param slack_m   0 to 0.5: every surface counts as nearer by that, so that this is the most that any position
  ///                  within slack_m can have.
  float likelihood_field_sum(std::span<const Point> points, const Point& position, double slack_m = 0) const;
  /// The same by the least distance in cells of 0.4 m: about the most that positions 0.2 m around can have. Far cheaper
  /// in a large map, where every lookup waits for memory.
  float coarse_likelihood_field_sum(std::span<const Point> points, const Point& position) const;

  /// First surface that a ray from `origin` crosses on its way to `target`.
  struct Crossing {
    MapFeatureNumber feature = {};  ///< none: the way is free
    double range_m = 0;             ///< from origin
    bool from_behind = false;       ///< crossed from the side on which it is not visible
  };
  /// The first surface between two points, both in the map [m].
  /// @param origin             where the ray begins.
  /// @param target             where it ends.
  /// @param min_penetration_m  surfaces that the target overshoots by less, measured perpendicular to them, do not
  ///                           count.
  Crossing first_crossing(const Point& origin, const Point& target, double min_penetration_m) const;

  /// Smallest rectangle around all features, min and max corner [m].
  std::array<Point, 2> bounds() const;

 private:
  struct Index;
  std::shared_ptr<const SemanticMap> map_;
  std::unique_ptr<const Index> index_;
};

}  // namespace opal
