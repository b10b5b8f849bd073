#include <opal/common/geometry.hpp>

#include <algorithm>

namespace opal {
namespace {

struct Move {
  const Pose2& T;
  Geometry operator()(const Point& p) const { return Point(T * p); }
  Geometry operator()(const OrientedPoint& p) const {
    return OrientedPoint{T * p.position, wrap_angle(p.heading_rad + T.heading_rad()), p.opening_rad};
  }
  Geometry operator()(const Segment& s) const { return transformed(T, s); }
  Geometry operator()(const Circle& c) const { return Circle{T * c.center, c.radius_m}; }
};

struct Anchor {
  Point operator()(const Point& p) const { return p; }
  Point operator()(const OrientedPoint& p) const { return p.position; }
  Point operator()(const Segment& s) const { return s.midpoint(); }
  Point operator()(const Circle& c) const { return c.center; }
};

struct DistanceTo {
  const Point& q;
  double operator()(const Point& p) const { return (p - q).norm(); }
  double operator()(const OrientedPoint& p) const { return (p.position - q).norm(); }
  double operator()(const Segment& s) const { return distance_m(s, q); }
  double operator()(const Circle& c) const { return std::abs((c.center - q).norm() - c.radius_m); }
};

}  // namespace

Geometry transformed(const Pose2& T_a_b, const Geometry& geometry_b) { return std::visit(Move{T_a_b}, geometry_b); }

Segment transformed(const Pose2& T_a_b, const Segment& segment_b) {
  return {T_a_b * segment_b.begin, T_a_b * segment_b.end};
}

Point anchor_of(const Geometry& geometry) { return std::visit(Anchor{}, geometry); }

double distance_m(const Geometry& geometry, const Point& point) { return std::visit(DistanceTo{point}, geometry); }

double distance_m(const Segment& segment, const Point& point) {
  const Point along = segment.end - segment.begin;
  const double squared = along.squaredNorm();
  const double u = squared > 0 ? std::clamp(along.dot(point - segment.begin) / squared, 0.0, 1.0) : 0.0;
  return (point - segment.begin - u * along).norm();
}

bool is_crossed_by_ray(const Segment& segment, const Point& from) {
  const Point &a = segment.begin, &b = segment.end;
  if ((a.y() > from.y()) == (b.y() > from.y())) return false;
  return from.x() < a.x() + (from.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

bool is_within(std::span<const Segment> edges, const Point& point) {
  return std::ranges::count_if(edges, [&](const Segment& e) { return is_crossed_by_ray(e, point); }) % 2 == 1;
}

}  // namespace opal
