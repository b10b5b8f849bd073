#include "map/view/map_size.hpp"

#include <opal/common/error.hpp>
#include <opal/common/quantile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace opal {
namespace {

Point middle_of(const SemanticMap& map, std::span<const MapFeatureNumber> numbers) {
  std::vector<double> x, y;
  for (MapFeatureNumber number : numbers) {
    const Point anchor = anchor_of(map.feature(number).geometry);
    x.push_back(anchor.x());
    y.push_back(anchor.y());
  }
  return {upper_median_of(std::move(x)), upper_median_of(std::move(y))};
}

}  // namespace

void expect_small_enough(const SemanticMap& map, std::span<const MapFeatureNumber> numbers, const Point& size_m) {
  constexpr double kMostArea_m2 = 2.5e9;
  if ((size_m.x() + 1) * (size_m.y() + 1) <= kMostArea_m2) return;
  const Point middle = middle_of(map, numbers);
  const auto far_m = [&](MapFeatureNumber number) { return distance_m(map.feature(number).geometry, middle); };
  const MapFeatureNumber outermost = *std::max_element(
      numbers.begin(), numbers.end(), [&](MapFeatureNumber a, MapFeatureNumber b) { return far_m(a) < far_m(b); });
  throw MapError(
      fmt::format("{}: {} is {:.1f} km from the middle of the others, and the map is {:.1f} km x {:.1f} km; "
                  "expected an area of {:.0f} km2 at most",
                  map.name(), map.feature(outermost).id, far_m(outermost) / 1000, size_m.x() / 1000, size_m.y() / 1000,
                  kMostArea_m2 / 1e6));
}

}  // namespace opal
