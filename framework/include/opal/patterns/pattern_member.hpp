#pragma once

#include <opal/patterns/pattern.hpp>

#include <nlohmann/json.hpp>

#include <vector>

namespace opal {

/// How much an observed member of a pattern may differ from the mapped one. What a template does not ask for is zero.
struct MemberTolerance {
  double radius_m = 0;     ///< of circles
  double opening_rad = 0;  ///< of corners
  double heading_rad = 0;  ///< of corners, relative to the pattern
};

/// From the options radius_tolerance_m, opening_tolerance_rad and heading_tolerance_rad, as far as they are there.
OPAL_EXPORT MemberTolerance read_member_tolerance(const nlohmann::json& options);

/// For templates over features that have a place (points, corners, circles): what a member says of itself, as numbers
/// that a rigid motion of the pattern leaves unchanged. A circle has its radius; a corner its opening and the cosine
/// and sine of its heading relative to an axis of the pattern (two numbers, for an angle has no order); a point none.
/// @param member      one feature of the pattern, in any frame.
/// @param axis        unit vector in the features' frame that moves with the pattern.
/// @param tolerance   goes into the tolerances of the invariants.
/// @param invariants  gets the numbers at its end.
OPAL_EXPORT void append_member(const Geometry& member, const Point& axis, const MemberTolerance& tolerance,
                               std::vector<Invariant>& invariants);

/// The same for a member that is known up to a half turn of the axis: the middle one of three in a line.
OPAL_EXPORT void append_turnable_member(const Geometry& member, const Point& axis, const MemberTolerance& tolerance,
                                        std::vector<Invariant>& invariants);

/// The same for two members of one kind that may be exchanged: of each number the larger one first, so that noise in
/// the choice of who is first changes no number.
OPAL_EXPORT void append_exchangeable(const Geometry& a, const Point& axis_a, const Geometry& b, const Point& axis_b,
                                     const MemberTolerance& tolerance, std::vector<Invariant>& invariants);

/// Orders two members of one kind, and says how sure the order is.
struct MemberRank {
  double difference = 0;  ///< > 0: a goes first; corner and circle numbers mixed into one
  double tolerance = 0;   ///< below this, noise decides: the pattern is symmetric as far as one can see
};
/// Which of two members of one kind goes first; each is judged relative to its own axis of the pattern.
OPAL_EXPORT MemberRank rank_members(const Geometry& a, const Point& axis_a, const Geometry& b, const Point& axis_b,
                                    const MemberTolerance& tolerance);

}  // namespace opal
