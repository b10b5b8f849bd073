#pragma once

#include <opal/plugin/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

/// Casts the scan's beams against the mapped surfaces, and judges them lopsidedly: the map holds only the static
/// building, so a beam that ends early met something unmapped and means little, while a beam that passes through a
/// mapped wall speaks against the hypothesis. Beams that pass through the same object share one cause, so an object is
/// taken for absent (glass, an open door, a wall that was never built) where that explains its beams better, at a price.
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
  void judge_hit(const opal::MapView& map, const opal::Point& eye, const opal::Point& end, Tally& tally) const;
  void judge_free(const opal::MapView& map, const opal::Point& eye, double bearing_rad, double range_max_m,
                  Tally& tally) const;

  double margin_at(double range_m) const { return margin_m_ + margin_per_m_ * range_m; }

  double weight_nat_, short_, through_, free_through_, sigma_m_, sigma_per_m_, margin_m_, margin_per_m_;
  double free_range_m_, absence_, floor_;
  int min_beams_;
};
