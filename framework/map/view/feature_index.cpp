#include "map/view/feature_index.hpp"

#include <algorithm>
#include <limits>

namespace opal {
namespace {

constexpr double kRadius_m = 0.1, kOpening_rad = 0.2, kOverhang_m = 0.3;

double size_of(const Geometry& geometry) {
  if (const auto* circle = std::get_if<Circle>(&geometry)) return circle->radius_m;
  if (const auto* corner = std::get_if<OrientedPoint>(&geometry)) return corner->opening_rad;
  if (const auto* segment = std::get_if<Segment>(&geometry)) return segment->length_m();
  return 0;
}

struct Range {
  double low, high;
};

Range accepted_by(const Geometry& observed) {
  const double size = size_of(observed);
  switch (kind_of(observed)) {
    case GeometryKind::circle: return {size - kRadius_m, size + kRadius_m};
    case GeometryKind::oriented_point: return {size - kOpening_rad, size + kOpening_rad};
    case GeometryKind::segment: return {size - kOverhang_m, std::numeric_limits<double>::infinity()};
    case GeometryKind::point: break;
  }
  return {0, 0};
}

}  // namespace

FeatureIndex::FeatureIndex(const MapView& map) {
  for (const MapFeatureNumber number : map.features()) {
    const MapFeature& feature = map.feature(number);
    sizes_[feature.type][feature.geometry.index()].push_back(size_of(feature.geometry));
  }
  for (auto& [type, by_geometry] : sizes_)
    for (std::vector<double>& sizes : by_geometry) {
      sizes.shrink_to_fit();
      std::sort(sizes.begin(), sizes.end());
    }
}

std::size_t FeatureIndex::expected(const Feature& observed) const {
  const auto found = sizes_.find(observed.type);
  if (found == sizes_.end()) return 0;
  const std::vector<double>& sizes = found->second[observed.geometry.index()];
  const Range range = accepted_by(observed.geometry);
  const auto from = std::lower_bound(sizes.begin(), sizes.end(), range.low);
  return static_cast<std::size_t>(std::upper_bound(from, sizes.end(), range.high) - from);
}

}  // namespace opal
