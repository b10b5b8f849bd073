#include <opal/import_kit/shaft_extent.hpp>

#include <algorithm>

namespace opal {

std::optional<ShaftExtent> shaft_extent(const std::vector<Point>& outline) {
  if (outline.empty()) return std::nullopt;
  Point low = outline.front(), high = outline.front();
  for (const Point& p : outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if (!(low + high).allFinite()) return std::nullopt;
  constexpr double kLeast_m = 0.5, kMost_m = 10;
  return ShaftExtent{(low + high) / 2, std::clamp((high - low).minCoeff() / 2, kLeast_m, kMost_m)};
}

}  // namespace opal
