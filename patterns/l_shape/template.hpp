#pragma once

#include <opal/patterns/pattern_member.hpp>
#include <opal/patterns/pattern_template.hpp>

namespace opal::l_shape {

/// Three features at a right angle (Hendrikx 2023, 4.3.3: eq. 4.1), in the order of the L-axis convention of 4.4.1: the
/// lower right end of the L, its corner, its upper end. A mirrored L has its ends the other way round, so no L is
/// symmetric. Dimensions: both legs, then what each member says of itself relative to the first leg.
class LShape final : public PatternTemplate {
 public:
  LShape(GeometryKind ends, GeometryKind corner, const nlohmann::json& options);
  PatternShape shape() const override;
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;

 private:
  GeometryKind ends_, corner_;
  double reach_m_, min_distance_m_, angle_tolerance_rad_, distance_tolerance_m_;
  MemberTolerance tolerance_;
};

}  // namespace opal::l_shape
