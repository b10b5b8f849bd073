#include "template.hpp"

#include <tuple>

namespace opal::collinear {

Collinear::Collinear(GeometryKind ends, GeometryKind middle, const nlohmann::json& options)
    : ends_(ends),
      middle_(middle),
      reach_m_(options.at("reach_m")),
      min_distance_m_(options.at("min_distance_m")),
      angle_tolerance_rad_(options.at("angle_tolerance_rad")),
      distance_tolerance_m_(options.at("distance_tolerance_m")),
      tolerance_(read_member_tolerance(options)) {}

PatternShape Collinear::shape() const { return {{ends_, middle_, ends_}, 2 * reach_m_, reach_m_}; }

std::optional<PatternInstance> Collinear::match(std::span<const Feature* const> features) const {
  const Point y1 = anchor_of(features[0]->geometry), y2 = anchor_of(features[1]->geometry),
              y3 = anchor_of(features[2]->geometry);
  const Point q1 = y1 - y2, q2 = y3 - y2;
  const double s1 = q1.norm(), s2 = q2.norm();
  if (!(s1 >= min_distance_m_ && s2 >= min_distance_m_)) return std::nullopt;  // NaN too
  const double bend =
      std::atan2(std::abs(cross(q1, q2)), -q1.dot(q2));  // pi - theta of eq. 4.1, exact when it is small
  if (!(bend <= angle_tolerance_rad_)) return std::nullopt;
  if (std::tuple(s2, y3.x(), y3.y()) < std::tuple(s1, y1.x(), y1.y())) return std::nullopt;

  const Point axis = (y3 - y1).normalized();
  PatternInstance instance;
  instance.members = {0, 1, 2};
  instance.invariants = {{s1, distance_tolerance_m_, Comparison::equal},
                         {s2, distance_tolerance_m_, Comparison::equal}};
  append_turnable_member(features[1]->geometry, axis, tolerance_, instance.invariants);
  append_exchangeable(features[0]->geometry, axis, features[2]->geometry, -axis, tolerance_, instance.invariants);
  instance.frame = {(y1 + y2 + y3) / 3, std::atan2(axis.y(), axis.x())};
  instance.symmetric = s2 - s1 < 2 * distance_tolerance_m_;
  return instance;
}

}  // namespace opal::collinear
