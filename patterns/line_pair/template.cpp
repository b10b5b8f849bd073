#include "template.hpp"

namespace opal::line_pair {

LinePair::LinePair(const nlohmann::json& options)
    : reach_m_(options.at("reach_m")),
      min_length_m_(options.at("min_length_m")),
      min_turn_rad_(options.at("min_turn_rad")),
      turn_tolerance_rad_(options.at("turn_tolerance_rad")),
      length_slack_m_(options.at("length_slack_m")),
      length_slack_share_(options.at("length_slack_share")) {}

PatternShape LinePair::shape() const { return {{GeometryKind::segment, GeometryKind::segment}, reach_m_}; }

std::optional<PatternInstance> LinePair::match(std::span<const Feature* const> features) const {
  const auto& first = std::get<Segment>(features[0]->geometry);
  const auto& second = std::get<Segment>(features[1]->geometry);
  if (!(first.length_m() >= min_length_m_ && second.length_m() >= min_length_m_)) return std::nullopt;  // NaN too
  const Point u = first.direction(), v = second.direction();
  const double turn = std::atan2(cross(u, v), u.dot(v));
  if (!(turn >= min_turn_rad_ && turn <= std::numbers::pi - min_turn_rad_)) return std::nullopt;

  const Point meeting = first.begin + u * (cross(second.begin - first.begin, v) / cross(u, v));
  PatternInstance instance;
  instance.members = {0, 1};
  instance.invariants = {{turn, turn_tolerance_rad_, Comparison::equal}};
  for (const auto& [segment, along] : {std::pair{first, u}, std::pair{second, v}}) {
    const double slack = length_slack_m_ + length_slack_share_ * segment.length_m();
    const double begin = along.dot(segment.begin - meeting), end = along.dot(segment.end - meeting);
    if (begin > reach_m_ || end < -reach_m_) return std::nullopt;
    instance.invariants.push_back({begin, slack, Comparison::mapped_at_most});
    instance.invariants.push_back({end, slack, Comparison::mapped_at_least});
  }
  instance.frame = {meeting, std::atan2((u + v).y(), (u + v).x())};
  return instance;
}

}  // namespace opal::line_pair
