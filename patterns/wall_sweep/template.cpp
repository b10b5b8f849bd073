#include "template.hpp"

#include <algorithm>

WallSweep::WallSweep(const nlohmann::json& options)
    : min_length_m_(options.at("min_length_m")),
      overhang_m_(options.at("overhang_m")),
      overhang_share_(options.at("overhang_share")) {}

opal::PatternShape WallSweep::shape() const { return {{opal::GeometryKind::segment}, 0}; }

std::optional<opal::PatternInstance> WallSweep::match(std::span<const opal::Feature* const> features) const {
  const auto& face = std::get<opal::Segment>(features[0]->geometry);
  const double length = face.length_m();
  if (!(length >= min_length_m_)) return std::nullopt;  // NaN too
  opal::PatternInstance instance;
  instance.members = {0};
  instance.overhang_m = std::max(overhang_m_, overhang_share_ * length);
  instance.invariants = {{length, instance.overhang_m, opal::Comparison::mapped_at_least}};
  instance.frame = {face.midpoint(), face.heading_rad()};
  instance.extent_min_m = -length / 2;
  instance.extent_max_m = length / 2;
  return instance;
}
