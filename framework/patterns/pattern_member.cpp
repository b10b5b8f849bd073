#include <opal/patterns/pattern_member.hpp>

namespace opal {
namespace {

double heading_to(const OrientedPoint& corner, const Point& axis) {
  return corner.heading_rad - std::atan2(axis.y(), axis.x());
}

/// One number per member that tells unequal ones apart: corners that look at each other, or along one wall, differ in
/// the sine, and those of a niche and of a pillar in the opening.
double rank_of(const Geometry& member, const Point& axis) {
  if (const auto* circle = std::get_if<Circle>(&member)) return circle->radius_m;
  const auto* corner = std::get_if<OrientedPoint>(&member);
  if (!corner) return 0;
  const double heading = heading_to(*corner, axis);
  return corner->opening_rad + std::cos(heading) + 2 * std::sin(heading);
}

double rank_tolerance(const Geometry& member, const MemberTolerance& tolerance) {
  if (kind_of(member) == GeometryKind::circle) return 2 * tolerance.radius_m;
  return 2 * (tolerance.opening_rad + 3 * tolerance.heading_rad);
}

}  // namespace

MemberTolerance read_member_tolerance(const nlohmann::json& options) {
  return {options.value("radius_tolerance_m", 0.0), options.value("opening_tolerance_rad", 0.0),
          options.value("heading_tolerance_rad", 0.0)};
}

void append_member(const Geometry& member, const Point& axis, const MemberTolerance& tolerance,
                   std::vector<Invariant>& invariants) {
  if (const auto* circle = std::get_if<Circle>(&member))
    invariants.push_back({circle->radius_m, tolerance.radius_m, Comparison::equal});
  if (const auto* corner = std::get_if<OrientedPoint>(&member)) {
    const double heading = heading_to(*corner, axis);
    invariants.push_back({corner->opening_rad, tolerance.opening_rad, Comparison::equal});
    invariants.push_back({std::cos(heading), tolerance.heading_rad, Comparison::equal});
    invariants.push_back({std::sin(heading), tolerance.heading_rad, Comparison::equal});
  }
}

void append_turnable_member(const Geometry& member, const Point& axis, const MemberTolerance& tolerance,
                            std::vector<Invariant>& invariants) {
  const auto* corner = std::get_if<OrientedPoint>(&member);
  if (!corner) return append_member(member, axis, tolerance, invariants);
  const double twice = 2 * heading_to(*corner, axis);  // the same after half a turn
  invariants.push_back({corner->opening_rad, tolerance.opening_rad, Comparison::equal});
  invariants.push_back({std::cos(twice), 2 * tolerance.heading_rad, Comparison::equal});
  invariants.push_back({std::sin(twice), 2 * tolerance.heading_rad, Comparison::equal});
}

void append_exchangeable(const Geometry& a, const Point& axis_a, const Geometry& b, const Point& axis_b,
                         const MemberTolerance& tolerance, std::vector<Invariant>& invariants) {
  std::vector<Invariant> of_b;
  append_member(b, axis_b, tolerance, of_b);
  const std::size_t from = invariants.size();
  append_member(a, axis_a, tolerance, invariants);
  for (std::size_t k = 0; k < of_b.size(); ++k)
    if (invariants[from + k].value < of_b[k].value) std::swap(invariants[from + k], of_b[k]);
  invariants.insert(invariants.end(), of_b.begin(), of_b.end());
}

MemberRank rank_members(const Geometry& a, const Point& axis_a, const Geometry& b, const Point& axis_b,
                        const MemberTolerance& tolerance) {
  return {rank_of(a, axis_a) - rank_of(b, axis_b), rank_tolerance(a, tolerance)};
}

}  // namespace opal
