#pragma once

#include <opal/patterns/pattern_template.hpp>

#include <nlohmann/json.hpp>

namespace opal::line_pair {

/// Two faces that are not parallel: they fix the pose. Invariants: the turn from the first to the second, and where
/// each begins and ends relative to the point where their lines meet. A mapped face must reach at least as far as the
/// observed one, which may be a part of it.
class LinePair final : public PatternTemplate {
 public:
  explicit LinePair(const nlohmann::json& options);
  PatternShape shape() const override;
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;

 private:
  double reach_m_, min_length_m_, min_turn_rad_, turn_tolerance_rad_, length_slack_m_, length_slack_share_;
};

}  // namespace opal::line_pair
