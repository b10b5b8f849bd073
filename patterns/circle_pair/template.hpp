#pragma once

#include <opal/plugin/pattern_template.hpp>

#include <nlohmann/json.hpp>

/// Two columns: the binary pattern of the thesis (4.3.1). Invariants: their distance and both radii, larger first. Equal
/// columns can be exchanged, so the pattern is symmetric then.
class CirclePair final : public opal::PatternTemplate {
 public:
  explicit CirclePair(const nlohmann::json& options);
  opal::PatternShape shape() const override;
  std::optional<opal::PatternInstance> match(std::span<const opal::Feature* const> features) const override;

 private:
  double reach_m_, distance_tolerance_m_, radius_tolerance_m_;
};
