#pragma once

#include <opal/patterns/pattern_template.hpp>

#include <nlohmann/json.hpp>

namespace opal::corner_pose {

/// One corner: a point with a direction fixes the pose. Invariant: the angle that is open to view.
class CornerPose final : public PatternTemplate {
 public:
  explicit CornerPose(const nlohmann::json& options);
  PatternShape shape() const override;
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;

 private:
  double opening_tolerance_rad_;
};

}  // namespace opal::corner_pose
