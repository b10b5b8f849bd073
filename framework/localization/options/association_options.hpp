#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace opal {

/// Where the search may look, if the robot's whereabouts are known roughly. Frame: `map`.
struct RegionPrior {
  Point center = Point::Zero();
  double radius_m = 0;
};

/// How hypotheses are spawned, grown, tracked and ended. Defaults are the best known; configs/thesis3.jsonld sets those of
/// Hendrikx (2023), table 3.1.
struct AssociationOptions {
  // Birth: which patterns are looked up, and how many candidates survive each filter.
  int seed_features = 8;            ///< best supported features per geometry that templates are offered
  int seed_patterns = 10;           ///< patterns looked up per scan, fewest expected candidates first
  int seed_lookup_limit = 2000;     ///< candidates per scan and template,
  int seed_places = 2000;           ///< and of all templates together: patterns that are expected least often first,
                                    ///< at least three of them; 0: any number
  int seed_close_looks = 200;       ///< of these, judged by all points of a thinned scan
  int seed_candidates = 30;         ///< kept by likelihood-field score of the scan to the map, one per place
  int seed_hypotheses = 12;         ///< kept by the scorers
  double seed_every_m = 0.5;        ///< driving, or
  double seed_every_rad = 1.0;      ///< turning, between searches for new hypotheses
  int seed_every_when_localized = 6; ///< only every n-th search while localized,
  int seed_every_when_likely = 2;   ///< or while a hypothesis has
  double likely_probability = 0.9;  ///< more than this
  int seed_places_per_chance = 1000; ///< a search that expects more places lets a further chance pass for each so many:
                                    ///< time per scan does not grow with the building; 0: it lets none pass
  int seed_loose_patterns = 3;      ///< the same for patterns with a free parameter
  double loose_below_nat = 1;       ///< patterns with a free parameter are tried if no candidate scores this
  double loose_until_nat = 3;       ///< and only while no hypothesis has gathered this much
  double slide_step_m = 0.2;        ///< step along a pattern's free parameter
  double birth_nat = -3.0;          ///< log prior of a new hypothesis against clutter
  int hindsight_scans = 40;         ///< scans seen before that a candidate is judged by, too; 0: none
  double hindsight_behind_nat = 7;  ///< a candidate that falls behind the best ones of the time by more is no hypothesis
  bool seed_from_stable = false;    ///< only stable local features may seed (thesis)

  // Growth: the association tree.
  int max_branches = 1;             ///< mapped features tried per local feature and hypothesis, nearest first
  bool branch_not_on_map = false;   ///< also branch "not on the map" when there is a mapped feature (thesis)
  int max_consecutive_not_on_map = 0; ///< gamma_*; 0: no limit
  int similar_depth = 0;            ///< N_sim: leaves that share their last associations are one; 0: off
  bool register_by_associations = false; ///< pose from associations (eq. 3.11) instead of scan and surfaces
  int registration_horizon = 5;     ///< N_d
  double gate_m = 0.4;              ///< distance of a local feature from its mapped counterpart
  double gate_rad = 0.2;
  double outlier_m = 0.5;           ///< delta: an association that is this far off rejects the hypothesis
  double outlier_rad = 0.5;         ///< alpha_c

  // Life.
  double memory = 0.99;             ///< share of gathered evidence kept per update
  double encounter_memory = 0.95;  ///< share of encounters kept per whole piece of evidence
  double novelty_m = 1.2;           ///< driving that makes a scan a whole new piece of evidence
  double novelty_rad = 1.5;
  double least_novelty = 0.05;
  double track_prior_position = 0.05; ///< how much dead reckoning weighs when a hypothesis is aligned with the map,
  double track_prior_heading = 0.3;   ///< as RefinementOptions: maps are wrong more often than the scan matcher
  double track_memory = 0.9;        ///< share of what is known about a hypothesis' pose that is kept per whole piece of
                                    ///< evidence; 0: it is where the newest scan puts it
  double track_jump_m = 0.2;        ///< as PoseFilterOptions
  int track_search = 15;            ///< hypotheses that get an alignment search when odometry is uncertain
  double merge_m = 0.3;             ///< hypotheses nearer than this
  double merge_rad = 0.1;           ///< and this are one
  double prune_nat = 7;             ///< worse than the best by this: ended
  int max_hypotheses = 120;

  // Status.
  double none_nat = 0;              ///< log weight of "none of these" before the first scan
  double none_scan_nat = 0.12;      ///< what a scan at a place that is not on the map would say for a wrong pose:
                                    ///< hypotheses must gather more than this to be believed
  double localized_probability = 0.99;
  double localized_novelty = 2;     ///< sum of the scans' tempering_weight over which that must hold,
  double localized_novelty_per_m = 1; ///< and so much more of it per metre of straight walls around the robot that are
  double localized_unmapped_m = 6;  ///< not on the map, beyond this much: it lacks walls, or the robot is elsewhere.
  double localized_most_novelty = 20; ///< Whatever walls are missing, this is enough, or localized_novelty if that is more
  double lost_scan_nat = -0.2;      ///< mean of the newest scans below this: lost

  // Being kidnapped.
  double carried_nat = -5.6;        ///< log prior that a robot was kidnapped whose scan does not continue those before
  double carried_unseen_nat = -10;  ///< the same if every scan continued those before
  double carried_drop = 0.5;        ///< a scan that does not continue those before says at least this share of what they said, on average
  double carried_match_share = 0.5; ///< a scan of whose points fewer lie on what was seen before does not continue it
  double carried_place_nat = -10;   ///< log prior of one place among all where it may have been put down
  double carried_scan_nat = 0.15;   ///< what a scan says for the place that the robot was kidnapped from
  double carried_most_nat = 8;      ///< suspicion grows up to this, so that good scans can take it back
  double carried_search_nat = 3;    ///< suspicion from which on the whole map is searched for where it was put down
  double carried_alarm_nat = 0.5;   ///< a scan that alone gives this suspicion is looked at even if the robot stands

  std::optional<RegionPrior> region;
};

/// Reads options by name; unknown names, wrong types and values out of range are errors.
/// @param where  file and JSON pointer of the object, for the message. @throws ConfigError.
OPAL_EXPORT AssociationOptions read_association_options(const nlohmann::json& options, const std::string& where);

}  // namespace opal
