#pragma once

#include "python_object.hpp"

#include <opal/localization/scoring/hypothesis_scorer.hpp>

/// A scorer that is a class of Python: `score(self, hypotheses, observation, map)` judges many in one call. A class
/// with `new_memory(self, map)` remembers.
class PythonScorer final : public opal::HypothesisScorer {
 public:
  explicit PythonScorer(const nlohmann::json& options);
  std::unique_ptr<opal::ScorerMemory> new_memory(const opal::MapView& map) const override;
  opal::Score score(const opal::Hypothesis& hypothesis, const opal::Observation& observation, const opal::MapView& map,
                    const opal::ScorerMemory* memory) const override;
  std::vector<opal::Score> score_all(std::span<const opal::Hypothesis* const> hypotheses,
                                     std::span<const opal::ScorerMemory* const> memories,
                                     const opal::Observation& observation, const opal::MapView& map) const override;
  void remember(opal::ScorerMemory& memory, const opal::ScorerMemory& seen, double weight) const override;
  void fade(opal::ScorerMemory& memory, double weight) const override;
  bool judges_associations() const override { return judges_associations_; }

 private:
  PythonObject object_;
  bool judges_associations_ = false, remembers_ = false, fades_ = false;
};
