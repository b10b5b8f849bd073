#include "patterns/neighbour_sight.hpp"

namespace opal {
namespace {

constexpr double kGrazing_m = 0.05;  // a map's faces do not meet to the centimetre
constexpr double kGrazing_rad = 0.1;

Point nearest_point(const Segment& face, const Point& p) {
  const Point along = face.direction();
  return face.begin + std::clamp(along.dot(p - face.begin), 0.0, face.length_m()) * along;
}

Point towards(const Geometry& geometry, const Point& other) {
  const auto* face = std::get_if<Segment>(&geometry);
  return face ? nearest_point(*face, other) : anchor_of(geometry);
}

/// The way `from` a feature to `to` leaves it on the side from which it can be seen.
bool is_open_towards(const Geometry& geometry, const Point& from, const Point& to) {
  const Point way = to - from;
  if (const auto* corner = std::get_if<OrientedPoint>(&geometry)) {
    const double off = wrap_angle(std::atan2(way.y(), way.x()) - corner->heading_rad);
    return std::abs(off) <= corner->opening_rad / 2 + kGrazing_rad;
  }
  if (const auto* face = std::get_if<Segment>(&geometry)) return face->normal().dot(way) > -kGrazing_m;
  return true;
}

/// The line passes through the face, clearly: its ends are on different sides, and it meets it between its ends.
bool passes_through(const Segment& line, const Segment& face) {
  const Point normal = face.normal(), along = face.direction();
  const double begin = normal.dot(line.begin - face.begin), end = normal.dot(line.end - face.begin);
  if (std::min(begin, end) > -kGrazing_m || std::max(begin, end) < kGrazing_m) return false;
  const Point meeting = line.begin + begin / (begin - end) * (line.end - line.begin);
  const double at = along.dot(meeting - face.begin);
  return at >= 0 && at <= face.length_m();
}

bool blocks(const Geometry& geometry, const Segment& line) {
  if (const auto* face = std::get_if<Segment>(&geometry)) return passes_through(line, *face);
  if (const auto* column = std::get_if<Circle>(&geometry))
    return (nearest_point(line, column->center) - column->center).norm() < column->radius_m;
  return false;
}

/// A surface on which a feature of the same object is, or in which: it does not hide it. What a detector sees on a
/// column may lie within it. Corners and faces have a side of their own, and look from it past other faces.
bool carries(const MapFeature& surface, const MapFeature& feature, const Point& at) {
  constexpr double kOnSurface_m = 0.3;
  if (!feature.object.exists() || surface.object != feature.object) return false;
  const auto* column = std::get_if<Circle>(&surface.geometry);
  if (column) return (at - column->center).norm() < column->radius_m + kOnSurface_m;
  const GeometryKind kind = kind_of(feature.geometry);
  const bool has_side = kind == GeometryKind::oriented_point || kind == GeometryKind::segment;
  return !has_side && distance_m(surface.geometry, at) < kOnSurface_m;
}

}  // namespace

Segment connecting_line(const Geometry& a, const Geometry& b) {
  const Point at_b = towards(b, anchor_of(a));
  return {towards(a, at_b), at_b};
}

bool see_each_other(const MapView& map, MapFeatureNumber a, MapFeatureNumber b) {
  const Geometry &first = map.feature(a).geometry, &second = map.feature(b).geometry;
  const Segment line = connecting_line(first, second);
  if (!is_open_towards(first, line.begin, line.end) || !is_open_towards(second, line.end, line.begin)) return false;
  if (line.length_m() < kGrazing_m) return true;
  for (const MapFeatureNumber other : map.within(line.midpoint(), line.length_m() / 2 + kGrazing_m))
    if (other != a && other != b && blocks(map.feature(other).geometry, line) &&
        !carries(map.feature(other), map.feature(a), line.begin) &&
        !carries(map.feature(other), map.feature(b), line.end))
      return false;
  return true;
}

}  // namespace opal
