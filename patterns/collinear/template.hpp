#pragma once

#include <opal/patterns/pattern_member.hpp>
#include <opal/patterns/pattern_template.hpp>

namespace opal::collinear {

/// Three features in a line (Hendrikx 2023, 4.3.3): the angle of eq. 4.1 at the middle one is straight. Slots: end,
/// middle, end, the shorter leg first. Dimensions: both legs, then what the middle member and the ends say of
/// themselves. Where the legs hardly differ, both pairings are possible, and the pattern is symmetric.
class Collinear final : public PatternTemplate {
 public:
  Collinear(GeometryKind ends, GeometryKind middle, const nlohmann::json& options);
  PatternShape shape() const override;
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;

 private:
  GeometryKind ends_, middle_;
  double reach_m_, min_distance_m_, angle_tolerance_rad_, distance_tolerance_m_;
  MemberTolerance tolerance_;
};

}  // namespace opal::collinear
