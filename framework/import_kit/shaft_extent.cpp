#include <opal/import_kit/shaft_extent.hpp>

#include <Eigen/Geometry>

#include <algorithm>

namespace opal {

std::optional<ShaftExtent> shaft_extent(const std::vector<Point>& outline) {
  if (outline.empty()) return std::nullopt;
  Eigen::AlignedBox2d box(outline.front());
  for (const Point& p : outline) box.extend(p);
  if (!(box.min() + box.max()).allFinite()) return std::nullopt;
  constexpr double kLeast_m = 0.5, kMost_m = 10;
  return ShaftExtent{box.center(), std::clamp(box.sizes().minCoeff() / 2, kLeast_m, kMost_m)};
}

}  // namespace opal
