#pragma once

#include <opal/patterns/pattern_template.hpp>

#include <nlohmann/json.hpp>

/// One corner: a point with a direction fixes the pose. Invariant: the angle that is open to view.
class CornerPose final : public opal::PatternTemplate {
 public:
  explicit CornerPose(const nlohmann::json& options);
  opal::PatternShape shape() const override;
  std::optional<opal::PatternInstance> match(std::span<const opal::Feature* const> features) const override;

 private:
  double opening_tolerance_rad_;
};
