#pragma once

#include "localization/scoring/place_comparison.hpp"
#include "localization/scoring/scorer_ensemble.hpp"

#include <opal/localization/options/localizer_options.hpp>

#include <algorithm>
#include <deque>

namespace opal {

/// What was seen before. A candidate is judged by it as if it had been a hypothesis all along: who comes late neither
/// starts with nothing against alternatives that have gathered evidence, nor escapes what was seen at places it must
/// have come from.
class OPAL_EXPORT RetrospectiveVerification {
 public:
  /// @param evidence_memory  as TrackingOptions.
  /// @param lead  that the status asks for: who is within it is not hopeless.
  RetrospectiveVerification(std::shared_ptr<const MapView> map, const ScorerEnsemble& ensemble,
                            const VerificationOptions& options, double evidence_memory, const AskedLead& lead = {})
      : map_(std::move(map)), ensemble_(ensemble), options_(options), evidence_memory_(evidence_memory), lead_(lead) {}

  /// Keeps an observation once the newest ones add up to a whole new piece of evidence.
  /// @param keyframe  of the observation.
  /// @param tempering_weight   how much of a new piece of evidence it is, in (0, 1].
  /// @param best_nat  what it said for the hypothesis that was the best then.
  /// @param places    of all hypotheses then.
  void remember(const Observation& observation, KeyframeId keyframe, double tempering_weight, double best_nat,
                std::vector<PlaceComparison::Place> places = {});

  /// The robot may have been kidnapped.
  struct Takeover {
    KeyframeId keyframe{0};  ///< the last one before
    double nat = 0;  ///< what a hypothesis starts with that takes over from the best one then, the price of being
                     ///< kidnapped, and to this place of all places, included
  };
  /// From now on a candidate may also be where the robot was kidnapped to: it is judged by what was seen since then
  /// only, and takes over what the best hypothesis had gathered by then, at a price.
  void suspect(const std::optional<Takeover>& kidnapping) { kidnapping_ = kidnapping; }
  /// The robot was kidnapped: what was seen up to this keyframe says nothing any more.
  void forget_until(KeyframeId keyframe);

  struct Verdict {
    double nat = 0;           ///< evidence of the scans that were kept, weighted as tracking would have weighted them
    ScorerMemories memories;  ///< of the hypothesis, with what these scans add
    KeyframeId kidnapped_after = {};  ///< that evidence rests on being kidnapped after this keyframe; none: it does not
    double inherited_nat = 0;         ///< part of it that another hypothesis had gathered by then
    int scans = 0;                    ///< how many of them were looked at
    bool hopeless = false;            ///< fell so far behind the best ones of the time that the rest was not looked at
    std::vector<Pose2> T_map_base;    ///< where the robot was at each of them, newest first
  };
  /// @param hypothesis  registration to the local map as it is now.
  Verdict verify(const Hypothesis& hypothesis, const LocalMap& local_map) const;

  /// A hypothesis that comes late was there before, too. @param T_map_base  as in its verdict.
  void place(HypothesisId hypothesis, const std::vector<Pose2>& T_map_base);
  /// The scans that are kept, oldest first. Valid until the next change.
  std::vector<PlaceComparison::Sight> sights() const;

  /// How much of a whole new piece of evidence a scan is after the newest one that is kept, in (0, 1].
  /// @param tempering_weight  of the scan after its predecessor.
  double since_newest(double tempering_weight) const {
    return scans_.empty() ? 1 : std::min(1.0, pending_ + tempering_weight);
  }

  void clear();

 private:
  struct PastScan {
    Pose2 T_local_base;
    std::vector<ObservedScan> scans;
    std::vector<Feature> features;
    std::vector<int> feature_scans;
    double tempering_weight = 0;  ///< of the observations since the one before
    double best_nat = 0;
    KeyframeId keyframe = {};
    std::vector<PlaceComparison::Place> places;  ///< of the hypotheses then, and of those that came later
  };

  /// Evidence of the scans that are kept, for the best hypotheses of the time.
  double best_nat() const;
  /// What a verdict on the scans since then becomes.
  Verdict if_kidnapped(const Verdict& since) const;

  std::shared_ptr<const MapView> map_;
  const ScorerEnsemble& ensemble_;
  VerificationOptions options_;
  double evidence_memory_;
  AskedLead lead_;
  std::deque<PastScan> scans_;  ///< newest first
  double pending_ = 0;          ///< tempering_weight since the newest
  std::optional<Takeover> kidnapping_;
};

}  // namespace opal
