#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

/// How near the scan's returns are to what is mapped: the likelihood field of Thrun, Burgard and Fox (2005), 6.4, as a
/// log ratio against returns that are spread evenly over the field.
class LikelihoodFieldScorer final : public opal::HypothesisScorer {
 public:
  explicit LikelihoodFieldScorer(const nlohmann::json& options);
  opal::Score score(const opal::Hypothesis& hypothesis, const opal::Observation& observation, const opal::MapView& map,
                    const opal::ScorerMemory*) const override;

 private:
  double weight_, sigma_m_, hit_share_;
};
