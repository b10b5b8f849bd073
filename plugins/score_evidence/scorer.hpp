#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

namespace opal::score_evidence {

/// Match ratio: each feature of the scan that a mapped feature explains adds log N(residual; 0, S) minus the log of
/// the clutter density, each that none explains costs a little. Hypotheses with different numbers of matches stay
/// comparable (Reid 1979; Blackman and Popoli 1999).
class EvidenceScorer final : public HypothesisScorer {
 public:
  explicit EvidenceScorer(const nlohmann::json& options);
  Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
              const ScorerMemory*) const override;
  bool judges_associations() const override { return false; }
  /// The largest features of the scan that no mapped feature explains.
  std::vector<Finding> explain(const Hypothesis& hypothesis, const Observation& observation,
                               const MapView& map) const override;

 private:
  struct Match;
  Match best_match(const Feature& observed, const Point& eye, const MapView& map) const;
  bool matches(const Feature& observed, const Point& eye, const MapView& map) const;
  Match match_face(const Segment& observed, const Point& eye, const MapView& map) const;
  Match match_point(const Feature& observed, const MapView& map) const;

  double weight_, sigma_m_, sigma_rad_, clutter_per_m_rad_, clutter_per_m2_, gate_chi2_, unmatched_nat_;
};

}  // namespace opal::score_evidence
