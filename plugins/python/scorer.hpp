#pragma once

#include "python_object.hpp"

#include <opal/localization/scoring/batch_scorer.hpp>
#include <opal/localization/scoring/hypothesis_scorer.hpp>

/// A scorer that is a class of Python: `score(self, hypotheses, observation, map)` judges many in one call.
class PythonScorer final : public opal::HypothesisScorer, public opal::BatchScorer {
 public:
  explicit PythonScorer(const nlohmann::json& options);
  opal::Score score(const opal::Hypothesis& hypothesis, const opal::Observation& observation, const opal::MapView& map,
                    const opal::ScorerMemory*) const override;
  std::vector<opal::Score> score_all(std::span<const opal::Hypothesis* const> hypotheses,
                                     const opal::Observation& observation, const opal::MapView& map) const override;
  bool judges_associations() const override { return judges_associations_; }

 private:
  PythonObject object_;
  bool judges_associations_ = false;
};
