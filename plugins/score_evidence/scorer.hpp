#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

/// Match ratio: each feature of the scan that a mapped feature explains adds log N(residual; 0, S) minus the log of
/// the clutter density, each that none explains costs a little. Hypotheses with different numbers of matches stay
/// comparable (Reid 1979; Blackman and Popoli 1999).
class EvidenceScorer final : public opal::HypothesisScorer {
 public:
  explicit EvidenceScorer(const nlohmann::json& options);
  opal::Score score(const opal::Hypothesis& hypothesis, const opal::Observation& observation, const opal::MapView& map,
                    const opal::ScorerMemory*) const override;
  bool judges_associations() const override { return false; }
  /// The largest features of the scan that no mapped feature explains.
  std::vector<opal::Finding> explain(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                     const opal::MapView& map) const override;

 private:
  struct Match;
  Match best_match(const opal::Feature& observed, const opal::Point& eye, const opal::MapView& map) const;
  bool matches(const opal::Feature& observed, const opal::Point& eye, const opal::MapView& map) const;
  Match match_face(const opal::Segment& observed, const opal::Point& eye, const opal::MapView& map) const;
  Match match_point(const opal::Feature& observed, const opal::MapView& map) const;

  double weight_, sigma_m_, sigma_rad_, clutter_per_m_rad_, clutter_per_m2_, gate_chi2_, unmatched_nat_;
};
