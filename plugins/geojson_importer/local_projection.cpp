#include "local_projection.hpp"

namespace opal::geojson_importer {
namespace {

constexpr double kEquator_m = 6378137;  // WGS 84
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kDegree_rad = radians(1);

}  // namespace

LocalProjection::LocalProjection(const Point& origin_deg) : origin_deg_(origin_deg) {
  const double latitude = origin_deg.y() * kDegree_rad;
  const double eccentricity2 = kFlattening * (2 - kFlattening);
  const double w = std::sqrt(1 - eccentricity2 * std::sin(latitude) * std::sin(latitude));
  const double across = kEquator_m / w, along = kEquator_m * (1 - eccentricity2) / (w * w * w);  // radii of curvature
  metres_per_degree_ = Point(across * std::cos(latitude), along) * kDegree_rad;
  tangent_ = std::abs(std::tan(latitude));
}

Point LocalProjection::to_map(const Point& position_deg) const {
  return metres_per_degree_.cwiseProduct(position_deg - origin_deg_);
}

double LocalProjection::error_m(const Point& p) const { return std::abs(p.x() * p.y()) * tangent_ / kEquator_m; }

}  // namespace opal::geojson_importer
