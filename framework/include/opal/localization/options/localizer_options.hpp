#pragma once

#include <opal/common/geometry.hpp>

#include <optional>

// Options of the localizer's stages, in pipeline order. Defaults are the best known; configs/thesis3.jsonld sets those
// of Hendrikx (2023), table 3.1. Ranges, units and meanings for people are in deployment/localizer_options.cpp; `opal
// plugins` prints them.

namespace opal {

/// How much a scan counts as evidence: scans taken close together are hardly independent.
struct TemperingOptions {
  double distance_m = 1.2;     ///< driving that makes a scan a whole, independent piece of evidence, or
  double angle_rad = 1.5;      ///< turning that does
  double least_weight = 0.05;  ///< of a scan that was taken where the one before was
};

/// When the map is searched for new hypotheses.
struct SearchScheduleOptions {
  double every_m = 0.5;             ///< driving, or
  double every_rad = 1.0;           ///< turning, between chances to search
  int every_when_localized = 6;     ///< chances that make one search while localized, or
  int every_when_likely = 2;        ///< while a hypothesis has
  double likely_probability = 0.9;  ///< more than this
};

/// Where the search may look, if the robot's whereabouts are known roughly. Frame: `map`.
struct RegionPrior {
  Point center = Point::Zero();  ///< [m]
  double radius_m = 0;           ///< the robot is no farther from the centre
};

/// Global search: which patterns are looked up, and how many candidates pass each coarse-to-fine filter.
struct SearchOptions {
  int patterns = 10;           ///< looked up per scan, fewest expected candidates first
  int lookup_limit = 2000;     ///< candidates per search and template,
  int places = 2000;           ///< and of all templates together: patterns that are expected least often first,
                               ///< three of them if that is at most five times as many; 0: any number
  int places_per_scan = 8000;  ///< looked at; a search that has more goes on at the next scans, so that time per
                               ///< scan does not grow with the building; 0: any number
  int close_looks = 200;       ///< of these, judged by all points of a thinned scan
  int candidates = 30;         ///< kept by likelihood-field score, one per place
  int hypotheses = 12;         ///< kept by the scorers
  int under_constrained_patterns = 3;      ///< looked up per scan, of those with a free parameter
  double under_constrained_below_nat = 1;  ///< they are looked up if no candidate scores this
  double under_constrained_until_nat = 3;  ///< and only while no hypothesis has gathered this much
  bool from_stable = false;                ///< only stable local features may be looked up (Hendrikx 2023)
  std::optional<RegionPrior> region;       ///< none: the whole map

  /// Whether the region admits a position of `base_link`; frame `map`.
  bool may_be_at(const Point& position) const {
    return !region || (position - region->center).norm() <= region->radius_m;
  }
};

/// Retrospective verification of candidates by scans seen before.
struct VerificationOptions {
  int scans = 40;         ///< that are kept; 0: none
  double behind_nat = 7;  ///< a candidate that falls behind the best ones of the time by more is no hypothesis
};

/// Growth of the association tree.
struct GrowthOptions {
  int max_branches = 1;                   ///< mapped features tried per local feature and hypothesis, nearest first
  bool branch_not_on_map = false;         ///< also branch "not on the map" when there is a mapped feature (thesis)
  int max_consecutive_not_on_map = 0;     ///< gamma_*; 0: no limit
  int similar_depth = 0;                  ///< N_sim: leaves that share their last associations are one; 0: off
  bool register_by_associations = false;  ///< pose from associations (eq. 3.11) instead of scan and surfaces
  int registration_horizon = 5;           ///< N_d
  double gate_m = 0.4;                    ///< distance of a local feature from its mapped counterpart
  double gate_rad = 0.2;                  ///< angle between the two
  double outlier_m = 0.5;                 ///< delta: an association that is this far off rejects the hypothesis
  double outlier_rad = 0.5;               ///< alpha_c
};

/// Tracking of hypotheses from scan to scan.
struct TrackingOptions {
  double evidence_memory = 0.99;  ///< share of gathered evidence kept per whole piece of evidence
  double prior_position = 0.05;   ///< how much dead reckoning weighs when a hypothesis is aligned with the map,
  double prior_heading = 0.3;     ///< as RefinementOptions: maps are wrong more often than the scan matcher
  double pose_memory = 0.9;       ///< share of what is known about a hypothesis' pose that is kept per whole piece of
                                  ///< evidence; 0: it is where the newest scan puts it
};

/// The set of hypotheses that are alive.
struct HypothesesOptions {
  double spawn_nat = -3.0;   ///< log prior of a new hypothesis against clutter
  double prune_nat = 7;      ///< worse than the best by this: ended
  int max_hypotheses = 120;  ///< the best ones are kept
};

/// Status: when the best hypothesis is called localized, when lost.
struct StatusOptions {
  double none_scan_nat = 0.12;          ///< what a scan at a place that is not on the map would say for a wrong pose:
                                        ///< hypotheses must gather more than this to be believed
  double localized_probability = 0.99;  ///< the best hypothesis must have more than this
  double localized_weight = 2;          ///< sum of the scans' tempering weights over which that must hold,
  double localized_weight_per_m = 1;  ///< and so much more of it per metre of straight walls around the robot that are
  double localized_unmapped_m = 6;    ///< not on the map, beyond this much: it lacks walls, or the robot is elsewhere.
  double localized_agreement = 0.5;   ///< Of the beams that end on mapped surfaces or pass through them, so many
                                      ///< should end there. If fewer do, the map is poor, or the robot elsewhere:
  double localized_weight_per_share = 30;   ///< so much more is asked for, times what is missing.
  double localized_least_agreement = 0.25;  ///< With fewer than so many the map is another place's: nothing helps.
  double localized_lead = 0.1;  ///< Of its evidence the best place must have so much more than any other place. Where
                                ///< two places look alike, what errors of the map and of the model add up to decides.
  double localized_most_weight = 20;  ///< Whatever is missing, this is enough, or localized_weight if that is more
  double lost_scan_nat = -0.2;        ///< mean of the newest scans below this: lost
};

/// Kidnap detection.
struct KidnappingOptions {
  double prior_nat = -5.6;  ///< log prior that a robot was kidnapped whose scan does not continue those before
  double scan_nat = 0.15;   ///< what a scan says for the place that the robot was kidnapped from
  double alarm_nat = 0.5;   ///< a scan that alone gives this suspicion is looked at even if the robot stands
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
