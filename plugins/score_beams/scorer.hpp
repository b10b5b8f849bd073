#pragma once

#include "encounters.hpp"
#include "tally.hpp"

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <nlohmann/json.hpp>

namespace opal::score_beams {

/// Casts the scan's beams against the mapped surfaces, and counts evidence cells of the local map rather than beams:
/// forty beams that end on one evidence cell are one coincidence, and so are forty beams that pass through one mapped
/// object; and what the hypothesis has met before is hardly news. What is one thing is decided by what is seen, not by
/// how a map draws it: a wall of two pieces tells as much as the same wall of one. With w(b) = b / (1 + b / enough), b
/// in beams of a hundred, and what was met before as b0:
///
///   nat = match * sum over evidence cells of w(b0 + b) - w(b0)     b: beams that end there on a surface, or on its
///   wall's other side
///       + line * sum over mapped lines of w(b0 + b) - w(b0)    b: beams that end on one of its faces, or on their
///       wall's other side
///       + end * sum over mapped lines of v(e0 + e) - v(e0)     e: ends of its faces that were seen, each as s(a0 + a)
///       - s(a0)
///             a: sum of exp(-2 d^2) over sightings at a distance of d in semi-axes of the gate, a0: the same before;
///             s(a) = a / (1 + a / enough sightings), v(e) = e / (1 + e / enough ends)
///       + hit * share of beams that end on a surface
///       - early * share of beams that end before a surface that lies ahead of them
///       - absent * sum over objects of w(b0 + b) - w(b0)     b: beams that pass through it
///       - conflict * sum over objects of (p * B + b * P) / (B + P)
///             b, p: shares of beams that end on it, that pass through it; B, P: the same with all that were met before
///       - through * share of beams that pass through an object and end on nothing mapped
///       - free_through * share of beams without return whose way crosses a surface
///
/// The map holds only the static building, so a beam that ends early met something unmapped and costs little. The form
/// is that of a conditional logit model (McFadden 1974) of the true pose among its alternatives, fitted to recorded
/// scans on intact, simplified and damaged maps; the weights of evidence cells and ends were chosen by whole runs on
/// them (docs/notebook/evidence.md).
class BeamScorer final : public HypothesisScorer {
 public:
  explicit BeamScorer(const nlohmann::json& options);
  std::unique_ptr<ScorerMemory> new_memory(const MapView& map) const override;
  Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
              const ScorerMemory* memory) const override;
  void remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const override;
  void fade(ScorerMemory& memory, double weight) const override;
  bool judges_associations() const override { return false; }
  /// The mapped objects that beams pass through, each with the beam that does so deepest.
  std::vector<Finding> explain(const Hypothesis& hypothesis, const Observation& observation,
                               const MapView& map) const override;

 private:
  struct Tally;
  /// The scan's beams and ends beside the map, from where the hypothesis has the robot.
  Tally compare(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                const Encounters& before) const;
  /// Sum of what the amounts are worth beyond what was met `before`; adds them to `now`.
  template <class Thing>
  static double news(const SumsBy<Thing>& beams, double each, double enough, const AmountsBy<Thing>& before,
                     AmountsBy<Thing>& now);
  void judge_return(const MapView& map, const Point& eye, const Point& end, EvidenceCell evidence_cell,
                    Tally& tally) const;
  void judge_ends(const MapView& map, const Pose2& T_map_base, const Feature& seen, const Encounters& before,
                  Tally& tally) const;
  void judge_free(const MapView& map, const Point& eye, double bearing_rad, double range_max_m, Tally& tally) const;

  double margin_at(double range_m) const { return margin_m_ + margin_per_m_ * range_m; }
  double conflict(const Tally& tally, double each, const Encounters& before) const;
  double likelihood_field(double distance_m, double range_m) const;

  double match_, line_, enough_, end_, enough_sightings_, enough_ends_, hit_, early_, absent_, conflict_, through_,
      free_through_;
  double sigma_m_, sigma_per_m_, margin_m_, margin_per_m_, other_side_m_, ahead_m_, free_range_m_, floor_,
      encounter_memory_;
  EndGate end_gate_;
  int min_beams_;
};

}  // namespace opal::score_beams
