#pragma once

#include <opal/common/export.hpp>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

namespace opal {

/// Position in a plane [m]; the frame is that of the thing that holds it.
using Point = Eigen::Vector2d;

/// An angle in degrees, for people and for files that state degrees.
constexpr double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }
/// An angle in radians [rad], of one in degrees.
constexpr double radians(double angle_deg) { return angle_deg * std::numbers::pi / 180; }

/// The equivalent angle in [-pi, pi).
inline double wrap_angle(double angle_rad) {
  const double two_pi = 2 * std::numbers::pi;
  const double wrapped = std::fmod(angle_rad + std::numbers::pi, two_pi);
  return wrapped < 0 ? wrapped + std::numbers::pi : wrapped - std::numbers::pi;
}

/// The direction of length 1 that has this heading.
inline Point unit_vector(double heading_rad) { return {std::cos(heading_rad), std::sin(heading_rad)}; }
/// `v` turned by +90 degrees.
inline Point left_of(const Point& v) { return {-v.y(), v.x()}; }
/// The z component of the cross product: positive if `b` points to the left of `a`.
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A rigid motion of the plane, SE(2). A variable `T_a_b` maps coordinates in frame b to frame a:
/// p_a = T_a_b * p_b. It is also the pose of frame b in frame a.
class Pose2 {
 public:
  Pose2() = default;
  /// A pose of its three numbers [m, m, rad]; the heading is counter-clockwise from the x axis and may be any angle.
  Pose2(double x_m, double y_m, double heading_rad) : Pose2(Point(x_m, y_m), heading_rad) {}
  /// A pose of a position [m] and a heading, which may be any angle.
  Pose2(const Point& position, double heading_rad)
      : position_(position),
        heading_rad_(wrap_angle(heading_rad)),
        cos_(std::cos(heading_rad)),
        sin_(std::sin(heading_rad)) {}

  const Point& position() const { return position_; }  ///< [m]
  double x() const { return position_.x(); }           ///< [m]
  double y() const { return position_.y(); }           ///< [m]
  double heading_rad() const { return heading_rad_; }  ///< in [-pi, pi)

  /// Turns a direction, without moving it.
  Point rotate(const Point& v) const { return {cos_ * v.x() - sin_ * v.y(), sin_ * v.x() + cos_ * v.y()}; }
  /// Turns and moves a position: from the frame b of `T_a_b` to the frame a.
  Point operator*(const Point& p) const { return position_ + rotate(p); }
  /// The motion `other`, then this one: T_a_b * T_b_c = T_a_c.
  Pose2 operator*(const Pose2& other) const { return {*this * other.position_, heading_rad_ + other.heading_rad_}; }
  /// The motion back: T_b_a of T_a_b.
  Pose2 inverse() const { return {Point(-(cos_ * x() + sin_ * y()), sin_ * x() - cos_ * y()), -heading_rad_}; }

 private:
  Point position_ = Point::Zero();
  double heading_rad_ = 0;
  double cos_ = 1;
  double sin_ = 0;
};

/// Distance [m] between two positions; headings do not count.
inline double distance_m(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }
/// The angle, in [0, pi], between two headings.
inline double angle_between_rad(const Pose2& a, const Pose2& b) {
  return std::abs(wrap_angle(a.heading_rad() - b.heading_rad()));
}

/// Between two poses: `from` at share 0, `to` at share 1; the heading turns the short way round.
inline Pose2 interpolated(const Pose2& from, const Pose2& to, double share) {
  return {from.position() + share * (to.position() - from.position()),
          from.heading_rad() + share * wrap_angle(to.heading_rad() - from.heading_rad())};
}

/// A point with a direction: a corner, a door post. `heading_rad` is the bisector of the angle that is open to
/// view; `opening_rad` in (0, 2 pi) is that angle: below pi for a concave corner (seen from inside a room), above
/// pi for a convex one (a pillar's edge).
struct OrientedPoint {
  Point position = Point::Zero();         ///< [m], in the frame of whoever holds it
  double heading_rad = 0;                 ///< of the bisector, counter-clockwise from the x axis
  double opening_rad = std::numbers::pi;  ///< the angle that is open to view
};

/// A straight face, seen from one side only: the visible side is to the left of begin -> end. A wall that can be
/// seen from both sides is two segments.
struct Segment {
  Point begin = Point::Zero();  ///< [m]; the right end for whoever looks at the visible side
  Point end = Point::Zero();    ///< [m]; the left end

  double length_m() const { return (end - begin).norm(); }        ///< from begin to end
  Point direction() const { return (end - begin).normalized(); }  ///< unit, from begin to end
  Point normal() const { return left_of(direction()); }           ///< unit, towards the visible side
  /// Of the direction, in [-pi, pi].
  double heading_rad() const { return std::atan2(end.y() - begin.y(), end.x() - begin.x()); }
  Point midpoint() const { return 0.5 * (begin + end); }  ///< [m]
};

/// A round column, or the rim of anything round.
struct Circle {
  Point center = Point::Zero();  ///< [m], in the frame of whoever holds it
  double radius_m = 0;           ///< of the rim
};

/// The closed set of shapes. Local map, registration, gates and drawing work on these; feature *types* are open.
using Geometry = std::variant<Point, OrientedPoint, Segment, Circle>;
/// The alternatives of Geometry, in the same order.
enum class GeometryKind {
  point,           ///< Point
  oriented_point,  ///< OrientedPoint
  segment,         ///< Segment
  circle           ///< Circle
};

/// Which shape a geometry is.
inline GeometryKind kind_of(const Geometry& geometry) { return static_cast<GeometryKind>(geometry.index()); }

/// The geometry moved by a rigid motion: T_a_b applied to a geometry in frame b gives it in frame a.
OPAL_EXPORT Geometry transformed(const Pose2& T_a_b, const Geometry& geometry_b);
/// The same for a segment; the visible side stays on the left.
OPAL_EXPORT Segment transformed(const Pose2& T_a_b, const Segment& segment_b);

/// The point itself, a circle's centre, a segment's midpoint.
OPAL_EXPORT Point anchor_of(const Geometry& geometry);

/// Shortest distance [m] from a point to a geometry; 0 on it. A circle is its rim.
OPAL_EXPORT double distance_m(const Geometry& geometry, const Point& point);
/// The same for a segment, both ends included.
OPAL_EXPORT double distance_m(const Segment& segment, const Point& point);

/// Whether a ray from a point along the x axis crosses a segment. The lower end belongs to the segment, the upper one
/// does not, so that a ring is entered and left once each where the ray meets two of its edges.
OPAL_EXPORT bool is_crossed_by_ray(const Segment& segment, const Point& from);
/// Whether a point is within closed rings, by the even-odd rule: a ring within a ring is a hole.
/// @param edges  of all rings, in any order and direction. @param point  in their frame.
OPAL_EXPORT bool is_within(std::span<const Segment> edges, const Point& point);

}  // namespace opal
