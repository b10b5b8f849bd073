#include "template.hpp"

namespace opal::corner_pose {

CornerPose::CornerPose(const nlohmann::json& options) : opening_tolerance_rad_(options.at("opening_tolerance_rad")) {}

PatternShape CornerPose::shape() const { return {{GeometryKind::oriented_point}, 0}; }

std::optional<PatternInstance> CornerPose::match(std::span<const Feature* const> features) const {
  const auto& corner = std::get<OrientedPoint>(features[0]->geometry);
  if (!corner.position.allFinite() || !std::isfinite(corner.heading_rad + corner.opening_rad)) return std::nullopt;
  PatternInstance instance;
  instance.members = {0};
  instance.invariants = {{corner.opening_rad, opening_tolerance_rad_, Comparison::equal}};
  instance.frame = {corner.position, corner.heading_rad};
  return instance;
}

}  // namespace opal::corner_pose
