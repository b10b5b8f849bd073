#pragma once

#include <opal/semantic_map.hpp>

#include <memory>
#include <span>
#include <vector>

namespace opal {

/// What one sensor can perceive of a map, with indices that answer spatial questions in microseconds. Immutable and
/// shared. Frame: `map`. Feature numbers are positions in SemanticMap::features().
class OPAL_EXPORT MapView {
 public:
  /// @throws ConfigError if the map holds nothing that this sensor can perceive.
  MapView(std::shared_ptr<const SemanticMap> map, const std::string& sensor);
  ~MapView();
  MapView(const MapView&) = delete;
  MapView& operator=(const MapView&) = delete;

  const SemanticMap& map() const;
  const MapFeature& feature(int number) const;
  /// All perceivable features.
  std::span<const int> features() const;
  /// Features with some point within radius_m of p, in no order (R-tree, exact).
  std::vector<int> within(const Point& p, double radius_m) const;

  /// The surface nearest to a point, if it is nearer than `reach_m()`: a lookup in a grid of `cell_m()` cells,
  /// so that the answer may be a surface that is farther by up to one cell.
  /// @return feature number, or -1.
  int nearest(const Point& p) const;
  /// Lower bound on the distance [m] from p to any surface, from the same grid; at most `clearance_cap_m()`.
  double clearance_m(const Point& p) const;
  double reach_m() const;
  double cell_m() const;
  double clearance_cap_m() const;

  /// Smoothed nearness to a surface in [0, 1] (1 on it), by grid lookup: for coarse, fast judgements.
  double nearness(const Point& p) const;

  /// First surface that a ray from `origin` to `target` crosses from its visible side or from behind.
  struct Crossing {
    int feature = -1;
    double range_m = 0;        ///< from origin
    double incidence_cos = 0;  ///< cosine between ray and normal; near 0 is grazing
    bool from_behind = false;
  };
  /// @param min_penetration_m  ignore surfaces that the target overshoots by less than this, measured
  ///                           perpendicular to the surface.
  /// @return feature -1 if the way is free.
  Crossing first_crossing(const Point& origin, const Point& target, double min_penetration_m) const;

  /// Smallest rectangle around all features, min and max corner [m].
  std::array<Point, 2> bounds() const;

 private:
  struct Index;
  std::shared_ptr<const SemanticMap> map_;
  std::unique_ptr<const Index> index_;
};

}  // namespace opal
