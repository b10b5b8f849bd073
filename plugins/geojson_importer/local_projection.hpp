#pragma once

#include <opal/common/geometry.hpp>

namespace opal::geojson_importer {

/// Degrees to metres around a place on the WGS 84 ellipsoid: equirectangular, x to the east, y to the north. Exact on
/// the axes through the origin; at (x, y), east-west distances are off by about x y tan(latitude) / 6378 km: 5 cm at
/// 500 m, 500 m and 52 degrees.
class LocalProjection {
 public:
  /// @param origin_deg  longitude, latitude; at most 85 degrees from the equator.
  explicit LocalProjection(const Point& origin_deg);

  Point to_map(const Point& position_deg) const;
  /// How far a point may be off [m].
  double error_m(const Point& p) const;

 private:
  Point origin_deg_;
  Point metres_per_degree_;
  double tangent_ = 0;
};

}  // namespace opal::geojson_importer
