#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

namespace opal::score_lack_of_fit {

/// Lack of fit of the newest associations under the hypothesis' registration (Hendrikx 2023, eq. 3.14), and the
/// heuristic probability of an association with nothing on the map (table 3.1). Both as a ratio against "all of this is
/// clutter", which divides every hypothesis of a tree's level by the same number: an association with nothing on the
/// map says nothing, a matched one ln(1 / p(*)) less its lack of fit. So hypotheses that were spawned at different
/// times compare.
class LackOfFitScorer final : public HypothesisScorer {
 public:
  explicit LackOfFitScorer(const nlohmann::json& options);
  Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
              const ScorerMemory*) const override;
  /// The association that fits worst.
  std::vector<Finding> explain(const Hypothesis& hypothesis, const Observation& observation,
                               const MapView& map) const override;

 private:
  struct Fit;
  Fit fit_of(const Hypothesis& hypothesis, const Observation& observation, const MapView& map) const;

  int horizon_;
  double sigma_m_, weight_, not_on_map_probability_, veto_m_;
};

}  // namespace opal::score_lack_of_fit
