#include "template.hpp"

#include <algorithm>

namespace opal::l_shape {

LShape::LShape(GeometryKind ends, GeometryKind corner, const nlohmann::json& options)
    : ends_(ends),
      corner_(corner),
      reach_m_(options.at("reach_m")),
      min_distance_m_(options.at("min_distance_m")),
      angle_tolerance_rad_(options.at("angle_tolerance_rad")),
      distance_tolerance_m_(options.at("distance_tolerance_m")),
      tolerance_(read_member_tolerance(options)) {}

PatternShape LShape::shape() const { return {{ends_, corner_, ends_}, 2 * reach_m_, reach_m_}; }

std::optional<PatternInstance> LShape::match(std::span<const Feature* const> features) const {
  const Point y1 = anchor_of(features[0]->geometry), y2 = anchor_of(features[1]->geometry),
              y3 = anchor_of(features[2]->geometry);
  const Point q1 = y1 - y2, q2 = y3 - y2;
  const double s1 = q1.norm(), s2 = q2.norm();
  if (!(s1 >= min_distance_m_ && s2 >= min_distance_m_)) return std::nullopt;  // NaN too
  const double turn = std::atan2(cross(q1, q2), q1.dot(q2));                   // positive: y1 is the lower right end
  if (!(std::abs(turn - std::numbers::pi / 2) <= angle_tolerance_rad_)) return std::nullopt;
  // Beside a very short leg, both ends of the other one are nearly right angles: nobody could tell the corner.
  if (std::atan2(std::min(s1, s2), std::max(s1, s2)) < 2 * angle_tolerance_rad_) return std::nullopt;

  const Point axis = (q1 / s1 - left_of(q2 / s2)).normalized();  // along the first leg, both legs telling it
  PatternInstance instance;
  instance.members = {0, 1, 2};
  instance.invariants = {{s1, distance_tolerance_m_, Comparison::equal},
                         {s2, distance_tolerance_m_, Comparison::equal}};
  for (const Feature* feature : features) append_member(feature->geometry, axis, tolerance_, instance.invariants);
  instance.frame = {(y1 + y2 + y3) / 3, std::atan2(axis.y(), axis.x())};
  return instance;
}

}  // namespace opal::l_shape
