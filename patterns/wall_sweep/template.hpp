#pragma once

#include <opal/patterns/pattern_template.hpp>

#include <nlohmann/json.hpp>

namespace opal::wall_sweep {

/// One face: fixes the heading and the distance, and leaves the place along the wall free. Under-constrained, so it is
/// looked up only where patterns that fix the pose say too little. Invariant: the length, a lower bound on the mapped
/// one.
class WallSweep final : public PatternTemplate {
 public:
  explicit WallSweep(const nlohmann::json& options);
  PatternShape shape() const override;
  std::optional<PatternInstance> match(std::span<const Feature* const> features) const override;

 private:
  double min_length_m_, overhang_m_, overhang_share_;
};

}  // namespace opal::wall_sweep
