#pragma once

#include "localization/decision/map_agreement.hpp"
#include "localization/search/retrospective_verification.hpp"

#include <opal/localization/options/localizer_options.hpp>

#include <optional>

namespace opal {

/// Asks after every scan whether the robot has been kidnapped: a cumulative sum test (Page 1954) of "the best
/// hypothesis was right up to some scan, and no scan since then was taken where it says" against "it is right". Who is
/// kidnapped also sees something else from one scan to the next; who enters a part of the building that the map has
/// wrong does not. In a room of the same shape the scan continues those before, but the map explains far less of it. As
/// long as every scan continues those before, a scan counts by its tempering weight.
class OPAL_EXPORT KidnapDetector {
 public:
  /// @param evidence_memory  as TrackingOptions.
  KidnapDetector(const KidnappingOptions& options, double evidence_memory)
      : options_(options), evidence_memory_(evidence_memory) {}

  /// A scan beside the best hypothesis.
  struct Evidence {
    KeyframeId keyframe = {};     ///< its id
    double tempering_weight = 1;  ///< how much of a new piece of evidence it is, in (0, 1]
    double match_share = 0;       ///< of its points that lie on what was seen before
    MapAgreement agreement{};     ///< of the map with it, by the hypothesis
    double scan_nat = 0;          ///< what it says for the hypothesis
    double gathered_nat = 0;      ///< what the hypothesis has gathered, this scan included
    bool established = false;     ///< the hypothesis had been believed before: suspicion begins with nothing else
    KeyframeId kidnapped_after =
        {};  ///< by the hypothesis, the robot was kidnapped after this keyframe; none: it was not
  };
  /// A best hypothesis by which the robot was kidnapped is watched for itself, from its first scan on. Suspicion
  /// against the one before stays, for candidates, until that kidnapping is settled.
  void add(const Evidence& evidence);
  /// The kidnapping that the best hypothesis rests on was one: nothing before it matters any more.
  /// @param inherited_nat  what was taken off the evidence of all hypotheses.
  void settle(double inherited_nat);
  void reset();

  /// The probability that the robot has been kidnapped, at the time that explains it best.
  double probability() const;
  /// Whether a scan that says this would be reason enough to look at it.
  bool alarming(double scan_nat) const;

  /// Whether the newest scan shows much less of what was seen before than scans usually do: the robot has perhaps been
  /// kidnapped, however well the scan fits.
  bool is_broken() const { return is_broken_; }

  /// There is reason to search the whole map anew: scans speak against the best hypothesis.
  bool is_suspicious() const { return is_suspicious(watch_); }
  /// The kidnapping that a candidate may rest on: from the best hypothesis, if there is suspicion against it, else from
  /// the one that it took over from.
  std::optional<RetrospectiveVerification::Takeover> suspected() const;

 private:
  /// What is held against one best hypothesis.
  struct Watch {
    KeyframeId kidnapped_after = {};  ///< by the hypothesis; none: it was not
    double suspicion_nat = 0;
    double usual_nat = 0;  ///< what scans said on average before there was suspicion
    RetrospectiveVerification::Takeover last_good;
  };

  void turn_to(const Evidence& seen);
  /// Whether it shows less of what was seen before than usual, and says much less for the place than scans did.
  bool is_doubted(const Evidence& seen) const;
  /// Some scan since then, or just before, did not continue those before.
  bool discontinued(const Watch& watch) const;
  bool is_suspicious(const Watch& watch) const;
  /// What a scan has to say, or it is a reason for suspicion [nat]: where it does not continue those before, about what
  /// they said, which a place that looks alike by chance does not.
  double wanted_nat() const;
  double share_of_usual_nat() const;

  KidnappingOptions options_;
  double evidence_memory_;
  Watch watch_;             ///< of the best hypothesis
  Watch before_;            ///< of the one that was the best before
  double usual_share_ = 0;  ///< of points on what was seen before
  AgreementFall agreement_fall_;
  bool is_broken_ = false;
  KeyframeId discontinued_;  ///< the newest keyframe that did not continue those before, or what they said of the map
  double since_discontinued_ = 0;  ///< sum of tempering weights from that keyframe on
};

}  // namespace opal
