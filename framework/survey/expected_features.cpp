#include "survey/expected_features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace opal {
namespace {

constexpr double kOverhang_m = 0.1;

Surface moved_by(Surface surface, const Point& by) {
  surface.origin += by;
  return surface;
}

bool is_surface(const Geometry& geometry) {
  return std::holds_alternative<Segment>(geometry) || std::holds_alternative<Circle>(geometry);
}

Point nearest_point(const Surface& surface, const Point& p) {
  if (surface.is_circle()) return surface.origin;
  return surface.origin +
         std::clamp(surface.direction.dot(p - surface.origin), 0.0, surface.size_m) * surface.direction;
}

}  // namespace

SurfaceOffset offset_from(const Surface& surface, const Point& p) {
  const Point from = p - surface.origin;
  if (!surface.is_circle()) return {surface.normal().dot(from), surface.direction.dot(from), surface.normal()};
  const double distance = from.norm();
  return {distance - surface.size_m, 0, distance > 1e-6 ? Point(from / distance) : Point(Point::UnitX())};
}

ExpectedFeatures::ExpectedFeatures(const MapView& map, const MapBelief& belief, const Point& eye, double view_m,
                                   double margin_m) {
  for (MapFeatureNumber number : map.within(eye, view_m)) {
    if (!is_surface(map.feature(number).geometry)) continue;
    const Surface surface = moved_by(map.surface(number), belief[number].moved);
    if (!surface.is_circle() && offset_from(surface, eye).offset_m < -margin_m) continue;  // seen from behind
    all_.push_back({number, surface, belief[number].observations > 0});
  }
  std::sort(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  for (std::size_t k = 0; k < all_.size(); ++k) spread(static_cast<int>(k), eye, margin_m);
}

int ExpectedFeatures::sector(const Point& direction) {
  const double turn = std::atan2(direction.y(), direction.x()) / (2 * std::numbers::pi) + 0.5;
  return std::clamp(static_cast<int>(turn * kSectors), 0, kSectors - 1);
}

/// Enters a surface into all sectors in which it may be seen.
void ExpectedFeatures::spread(int position, const Point& eye, double margin_m) {
  const Surface& surface = all_[position].surface;
  const Point nearest = nearest_point(surface, eye);
  const double distance = (nearest - eye).norm();
  const double reach = margin_m + (surface.is_circle() ? surface.size_m : 0);
  const Point end = surface.is_circle() ? surface.origin : Point(surface.origin + surface.size_m * surface.direction);
  const double margin = distance > reach ? std::asin(reach / distance) : std::numbers::pi;
  const double from = std::atan2(surface.origin.y() - eye.y(), surface.origin.x() - eye.x());
  const double turn = wrap_angle(std::atan2(end.y() - eye.y(), end.x() - eye.x()) - from);
  const double width = 2 * std::numbers::pi / kSectors;
  const double low = std::min(from, from + turn) - margin, high = std::max(from, from + turn) + margin;
  const int sectors = std::min(kSectors, static_cast<int>(std::ceil((high - low) / width)) + 1);
  const int first = sector(unit_vector(low));
  for (int k = 0; k < sectors; ++k) fan_[(first + k) % kSectors].push_back(position);
}

int ExpectedFeatures::nearest(const Point& eye, const Point& p, double within_m) const {
  int best = -1;
  double best_m = within_m;
  for (int k : towards(p - eye)) {
    const Surface& surface = all_[k].surface;
    const SurfaceOffset at = offset_from(surface, p);
    if (std::abs(at.offset_m) >= best_m || at.normal.dot(p - eye) >= 0) continue;
    if (!surface.is_circle() && (at.along_m < -kOverhang_m || at.along_m > surface.size_m + kOverhang_m)) continue;
    best = k;
    best_m = std::abs(at.offset_m);
  }
  return best;
}

}  // namespace opal
