#include "template.hpp"

#include <algorithm>

namespace opal::wall_sweep {

WallSweep::WallSweep(const nlohmann::json& options)
    : min_length_m_(options.at("min_length_m")),
      overhang_m_(options.at("overhang_m")),
      overhang_share_(options.at("overhang_share")) {}

PatternShape WallSweep::shape() const { return {{GeometryKind::segment}, 0}; }

std::optional<PatternInstance> WallSweep::match(std::span<const Feature* const> features) const {
  const auto& face = std::get<Segment>(features[0]->geometry);
  const double length = face.length_m();
  if (!(length >= min_length_m_)) return std::nullopt;  // NaN too
  PatternInstance instance;
  instance.members = {0};
  instance.overhang_m = std::max(overhang_m_, overhang_share_ * length);
  instance.invariants = {{length, instance.overhang_m, Comparison::mapped_at_least}};
  instance.frame = {face.midpoint(), face.heading_rad()};
  instance.extent_min_m = -length / 2;
  instance.extent_max_m = length / 2;
  return instance;
}

}  // namespace opal::wall_sweep
