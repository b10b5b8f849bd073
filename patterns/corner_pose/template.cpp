#include "template.hpp"

CornerPose::CornerPose(const nlohmann::json& options) : opening_tolerance_rad_(options.at("opening_tolerance_rad")) {}

opal::PatternShape CornerPose::shape() const { return {{opal::GeometryKind::oriented_point}, 0}; }

std::optional<opal::PatternInstance> CornerPose::match(std::span<const opal::Feature* const> features) const {
  const auto& corner = std::get<opal::OrientedPoint>(features[0]->geometry);
  if (!corner.position.allFinite() || !std::isfinite(corner.heading_rad + corner.opening_rad)) return std::nullopt;
  opal::PatternInstance instance;
  instance.members = {0};
  instance.invariants = {{corner.opening_rad, opening_tolerance_rad_, opal::Comparison::equal}};
  instance.frame = {corner.position, corner.heading_rad};
  return instance;
}
