#pragma once

#include <opal/map/view/map_view.hpp>
#include "survey/map_belief.hpp"

#include <array>
#include <span>
#include <vector>

namespace opal {

/// A face or column that the map holds near the robot, where it is believed to be. Frame: `map`.
struct ExpectedFeature {
  MapFeatureNumber number = {};
  Surface surface;     ///< corrected by what is believed
  bool known = false;  ///< it has been recognized before, so its offset is known
};

/// Distance from a surface [m]: a face's along its normal, positive on the visible side; a column's from the rim.
struct SurfaceOffset {
  double offset_m = 0;
  double along_m = 0;  ///< from a face's begin; 0 for a column
  Point normal = Point::Zero();
};
SurfaceOffset offset_from(const Surface& surface, const Point& p);

/// Points so near lie on a surface.
inline constexpr double kOnSurface_m = 0.15;

/// The map's answer to "what may the laser see from here" (Hendrikx 2023, 2.4: the map is queried first), by bearing.
class ExpectedFeatures {
 public:
  /// @param eye  the laser, map frame; @param view_m  how far it is asked about.
  /// @param margin_m  how far pose and map together may be off.
  ExpectedFeatures(const MapView& map, const MapBelief& belief, const Point& eye, double view_m, double margin_m);

  const std::vector<ExpectedFeature>& all() const { return all_; }
  /// Positions in all() of what may be seen in a direction (any length).
  std::span<const int> towards(const Point& direction) const { return fan_[sector(direction)]; }
  /// The surface nearest to `p` of those that `eye` sees from their visible side. @return position in all(), or -1.
  int nearest(const Point& eye, const Point& p, double within_m) const;

 private:
  static constexpr int kSectors = 72;
  static int sector(const Point& direction);
  void spread(int position, const Point& eye, double margin_m);

  std::vector<ExpectedFeature> all_;
  std::array<std::vector<int>, kSectors> fan_;
};

}  // namespace opal
