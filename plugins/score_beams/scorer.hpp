#pragma once

#include <opal/plugin/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

/// Casts the scan's beams against the mapped surfaces, and counts surfaces rather than beams: forty beams that end on
/// one wall are one coincidence, and so are forty beams that pass through one.
///
///   nat = match * sum over surfaces of m / (1 + m / enough)      m: beams that end on it, or on the wall's other side
///       - ahead * share of the beams that had a surface ahead     whether they reached it or ended early
///       - through * sum over objects of sqrt(t)                  t: beams that pass through it
///       - free_through * share of the beams without return whose way crosses a surface
///
/// The map holds only the static building, so a beam that ends early costs no more than its failure to match: it met
/// something unmapped. The form and its weights are those of a conditional logit model (McFadden 1974) of the true pose
/// among its rivals, over recorded scans and intact, simplified and damaged maps (docs/experiments.md).
class BeamScorer final : public opal::HypothesisScorer {
 public:
  explicit BeamScorer(const nlohmann::json& options);
  opal::Score score(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                    const opal::MapView& map) const override;
  /// The mapped objects that beams pass through, each with the beam that does so deepest.
  std::vector<opal::Finding> explain(const opal::Hypothesis& hypothesis, const opal::Observation& observation,
                                     const opal::MapView& map) const override;

 private:
  struct Tally;
  void judge_return(const opal::MapView& map, const opal::Point& eye, const opal::Point& end, Tally& tally) const;
  void judge_free(const opal::MapView& map, const opal::Point& eye, double bearing_rad, double range_max_m,
                  Tally& tally) const;

  double margin_at(double range_m) const { return margin_m_ + margin_per_m_ * range_m; }
  double nearness(double distance_m, double range_m) const;

  double match_, enough_, hit_, early_, absent_, through_, free_through_;
  double sigma_m_, sigma_per_m_, margin_m_, margin_per_m_, other_side_m_, ahead_m_, free_range_m_, floor_;
  int min_beams_;
};
