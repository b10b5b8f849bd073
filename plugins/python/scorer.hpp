#pragma once

#include "python_object.hpp"

#include <opal/localization/scoring/hypothesis_scorer.hpp>

namespace opal::python_classes {

/// A scorer that is a class of Python: `score(self, hypotheses, observation, map)` judges many in one call. A class
/// with `new_memory(self, map)` remembers.
class PythonScorer final : public HypothesisScorer {
 public:
  explicit PythonScorer(const nlohmann::json& options);
  std::unique_ptr<ScorerMemory> new_memory(const MapView& map) const override;
  Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
              const ScorerMemory* memory) const override;
  std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses,
                               std::span<const ScorerMemory* const> memories, const Observation& observation,
                               const MapView& map) const override;
  void remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const override;
  void fade(ScorerMemory& memory, double weight) const override;
  bool judges_associations() const override { return judges_associations_; }

 private:
  PythonObject object_;
  bool judges_associations_ = false, remembers_ = false, fades_ = false;
};

}  // namespace opal::python_classes
