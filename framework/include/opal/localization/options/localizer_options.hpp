#pragma once

#include <opal/common/geometry.hpp>

#include <algorithm>
#include <limits>
#include <optional>

// Options of the localizer's stages, in pipeline order. Defaults are the best known; configs/thesis3.jsonld sets those
// of Hendrikx (2023), table 3.1. Ranges, units and meanings for people are in deployment/search_fields.cpp,
// hypothesis_fields.cpp and decision_fields.cpp; `opal plugins` prints them.

namespace opal {

/// How much a scan counts as evidence: scans taken close together are hardly independent.
struct TemperingOptions {
  double distance_m = 1.2;     ///< driving that makes a scan a whole, independent piece of evidence
  double angle_rad = 1.5;      ///< turning that makes a scan a whole, independent piece of evidence
  double least_weight = 0.05;  ///< weight of a scan that was taken where the one before was
};

/// When the map is searched for new hypotheses.
struct SearchScheduleOptions {
  double every_m = 0.5;             ///< driving that brings a chance to search
  double every_rad = 1.0;           ///< turning that brings a chance to search
  int every_when_localized = 6;     ///< chances that make one search while the robot is localized
  int every_when_likely = 2;        ///< chances that make one search while the best place is likely
  double likely_probability = 0.9;  ///< probability above which the best place is likely
};

/// Where the search may look, if the robot's whereabouts are known roughly. Frame: `map`.
struct RegionPrior {
  Point center = Point::Zero();  ///< middle of the region [m]
  double radius_m = 0;           ///< the robot is no farther from the centre than this
};

/// Global search: which patterns are looked up, and how many candidates pass each coarse-to-fine filter.
struct SearchOptions {
  int patterns = 10;           ///< patterns looked up per scan, fewest expected candidates first
  int lookup_limit = 2000;     ///< candidates per search and template
  int places = 2000;           ///< candidates per search of all templates together, of the patterns that are expected
                               ///< least often; three patterns may have five times as many; 0: any number
  int places_per_scan = 8000;  ///< places looked at per scan; a search that has more goes on at the next scans, so
                               ///< that time per scan does not grow with the building; 0: any number
  int close_looks = 200;       ///< places that are judged by all points of a thinned scan
  int candidates = 30;         ///< candidates kept by likelihood-field score, one per place
  int hypotheses = 12;         ///< candidates kept by the scorers, one per place
  int under_constrained_patterns = 3;      ///< patterns with a free parameter that are looked up per scan
  double under_constrained_below_nat = 1;  ///< patterns with a free parameter are looked up if no candidate scores this
  double under_constrained_until_nat = 3;  ///< patterns with a free parameter are looked up while no hypothesis has
                                           ///< gathered this much; while not localized, also where there are no others
  bool from_stable = false;                ///< only stable local features may be looked up (Hendrikx 2023)
  std::optional<RegionPrior> region;       ///< where candidates may be; none: on the whole map

  /// Whether the region admits a position of `base_link`; frame `map`.
  bool may_be_at(const Point& position) const {
    return !region || (position - region->center).norm() <= region->radius_m;
  }
};

/// Retrospective verification of candidates by scans seen before.
struct VerificationOptions {
  int scans = 40;         ///< earlier scans that are kept; 0: none
  double behind_nat = 7;  ///< a candidate that falls behind the best ones of the time by more is no hypothesis
};

/// Growth of the association tree.
struct GrowthOptions {
  int max_branches = 1;                   ///< mapped features tried per local feature and hypothesis, nearest first
  bool branch_not_on_map = false;         ///< also branch "not on the map" when there is a mapped feature (thesis)
  int max_consecutive_not_on_map = 0;     ///< gamma_*; 0: no limit
  int similar_depth = 0;                  ///< N_sim: leaves that share their last associations are one; 0: off
  bool register_by_associations = false;  ///< pose from associations (eq. 3.11) instead of scan and surfaces
  int registration_horizon = 5;           ///< N_d: last associations that give that pose
  double gate_m = 0.4;                    ///< most distance of a local feature from its mapped counterpart
  double gate_rad = 0.2;                  ///< most angle between a local feature and its mapped counterpart
  double outlier_m = 0.5;    ///< delta: an association that is farther off rejects the branch, or is forgotten
  double outlier_rad = 0.5;  ///< alpha_c: an association that is turned by more is forgotten
};

/// Tracking of hypotheses from scan to scan.
struct TrackingOptions {
  double evidence_memory = 0.99;  ///< share of gathered evidence kept per whole piece of evidence
  double prior_position = 0.05;   ///< weight of dead reckoning's position when a hypothesis is aligned with the map,
                                 ///< per scan point and relative to it: maps are wrong more often than the scan matcher
  double prior_heading = 0.3;  ///< weight of dead reckoning's heading when a hypothesis is aligned with the map,
                               ///< per scan point
  double pose_memory = 0.9;    ///< share of what is known about a hypothesis' pose that is kept per whole piece of
                               ///< evidence; 0: it is where the newest scan puts it
};

/// The set of hypotheses that are alive.
struct HypothesesOptions {
  double spawn_nat = -3.0;   ///< log prior of a new hypothesis against clutter
  double prune_nat = 7;      ///< worse than the best by this: ended
  int max_hypotheses = 120;  ///< the best ones are kept
  int compared_places = 4;   ///< so many of the best are compared with each other by the beams that tell them apart
};

/// The lead that one place must have over another one, in evidence.
struct AskedLead {
  double share = 0;                                           ///< of its own evidence
  double most_nat = std::numeric_limits<double>::infinity();  ///< however much that is

  /// @param evidence_nat  of the place that must lead.
  double nat(double evidence_nat) const { return std::min(share * evidence_nat, most_nat); }
  /// How far behind the best place others are kept: the status asks about those within the lead.
  /// @param limit_nat  so far in any case. @param best_nat  evidence of the best place.
  double kept_within_nat(double limit_nat, double best_nat) const { return std::max(limit_nat, nat(best_nat)); }
};

/// Status: when the best hypothesis is called localized, when lost.
struct StatusOptions {
  /// What a scan at a place that is not on the map says for a wrong pose: hypotheses must gather more to be believed
  /// [nat].
  double none_scan_nat = 0.12;
  /// Probability that the best place must exceed.
  double localized_probability = 0.99;
  /// Sum of tempering weights over which the best place must have that probability.
  double localized_weight = 2;
  /// Additional tempering weight required per metre of unmapped wall beyond `localized_unmapped_m` [1/m]: the map lacks
  /// walls, or the robot is elsewhere.
  double localized_weight_per_m = 1;
  /// Straight walls around the robot that may be missing on the map without further evidence [m].
  double localized_unmapped_m = 6;
  /// Least share of beams that end on mapped surfaces, of those that end there or pass through, without further
  /// evidence. With a smaller share the map is poor, or the robot elsewhere.
  double localized_agreement = 0.5;
  /// Additional tempering weight required per unit by which that share is below `localized_agreement`.
  double localized_weight_per_share = 30;
  /// Share of beams that end on mapped surfaces below which the map is another place's: no evidence is enough.
  double localized_least_agreement = 0.25;
  /// The same over the newest twenty or so pieces of evidence, whichever place was the best in each: a map that does
  /// not explain the drive is not believed where it explains a part of it. 0: any share will do.
  double localized_drive_agreement = 0;
  /// Share of its evidence by which the best place must lead over any other place. Where two places look alike, what
  /// errors of the map and of the model add up to decides.
  double localized_lead = 0.15;
  /// Most that this lead must be, however much evidence there is [nat]. Storeys that are alike have most of it in
  /// common.
  double localized_lead_nat = 12;
  /// Most tempering weight that is required, whatever is missing; `localized_weight` if that is more.
  double localized_most_weight = 20;
  /// How far off a pose may be that is localized: three standard deviations [m].
  double localized_within_m = 1;
  /// And how far turned [rad].
  double localized_within_rad = 0.175;
  /// Mean score of the newest scans below which a robot that was localized is lost [nat].
  double lost_scan_nat = -0.2;

  /// By which the best place must lead over any other place.
  AskedLead lead() const { return {localized_lead, localized_lead_nat}; }
};

/// Kidnap detection.
struct KidnappingOptions {
  double prior_nat = -5.6;  ///< log prior that a robot was kidnapped whose scan does not continue those before
  double scan_nat = 0.15;   ///< what a scan says for the place that the robot was kidnapped from
  double alarm_nat = 0.5;   ///< a scan that alone gives this suspicion is looked at even if the robot stands
  /// A scan that says less than half of what scans said for the place does not continue those before if it shows less
  /// than this, times the usual share, of what was seen before. Nothing is then called localized until new evidence
  /// confirms the place. 0: it does not matter what the scan says.
  double doubted_share = 0;
  /// After a scan that does not continue those before, for so many pieces of new evidence, scans are held against what
  /// was said before it. 0: until one of them says as much.
  double doubted_weight = 0;
};

/// Rides in lifts that the map has (StoreyConnection).
struct RideOptions {
  double stand_s = 2;  ///< a robot that stands in a lift for so long may be on any storey that the lift serves
};

/// The options of all stages.
struct LocalizerOptions {
  TemperingOptions tempering;        ///< how much each scan counts
  SearchScheduleOptions schedule;    ///< when the map is searched
  SearchOptions search;              ///< how the map is searched
  VerificationOptions verification;  ///< by earlier scans
  GrowthOptions growth;              ///< of the association tree
  TrackingOptions tracking;          ///< from scan to scan
  HypothesesOptions hypotheses;      ///< which begin and which end
  StatusOptions status;              ///< when the robot is localized or lost
  KidnappingOptions kidnapping;      ///< when the robot was carried off
  RideOptions rides;                 ///< when a lift may have carried the robot
};

}  // namespace opal
