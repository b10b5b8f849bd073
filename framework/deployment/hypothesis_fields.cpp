#include "deployment/stage_fields.hpp"

namespace opal {

const StageFields<TemperingOptions>& fields_of(const TemperingOptions&) {
  using O = TemperingOptions;
  static const StageFields<O> all = {
      {"distance_m", &O::distance_m, "m", 0.001, 1000,
       "Distance to drive from one scan to the next that makes the next one a whole piece of evidence, of weight 1. "
       "After less, a scan weighs less."},
      {"angle_rad", &O::angle_rad, "rad", 0.001, 1000,
       "Angle to turn from one scan to the next that makes the next one a whole piece of evidence, of weight 1."},
      {"least_weight", &O::least_weight, "", 0, 1,
       "Weight of a scan that is taken exactly where the one before was taken. 0: a robot that stands learns nothing."},
  };
  return all;
}

const StageFields<GrowthOptions>& fields_of(const GrowthOptions&) {
  using O = GrowthOptions;
  static const StageFields<O> all = {
      {"max_branches", &O::max_branches, "", 1, 1000,
       "Most mapped features that a new local feature may be paired with, per hypothesis, nearest first. Each makes a "
       "branch of the association tree."},
      {"branch_not_on_map", &O::branch_not_on_map, "", 0, 0,
       "A new local feature also gets a branch where it is not on the map. Otherwise it gets this branch only if no "
       "mapped feature is near."},
      {"max_consecutive_not_on_map", &O::max_consecutive_not_on_map, "", 0, kUnlimited,
       "A hypothesis ends after more associations in a row that say \"not on the map\". 0: no limit."},
      {"similar_depth", &O::similar_depth, "", 0, 1000,
       "Hypotheses whose newest associations agree are merged. This many associations are compared. 0: off."},
      {"register_by_associations", &O::register_by_associations, "", 0, 0,
       "The pose of a hypothesis comes from its associations, as in Hendrikx (2023). Otherwise it comes from aligning "
       "each scan to the mapped surfaces."},
      {"registration_horizon", &O::registration_horizon, "", 2, 1000,
       "Number of newest associations that give the pose, if register_by_associations is true."},
      {"gate_m", &O::gate_m, "m", 0, 100,
       "A local feature is paired only with mapped features that are no farther away than this."},
      {"gate_rad", &O::gate_rad, "rad", 0, 4,
       "A local feature is paired only with mapped features that are turned against it by no more than this."},
      {"outlier_m", &O::outlier_m, "m", 0, 100,
       "An association is given up if its two features are farther apart than this."},
      {"outlier_rad", &O::outlier_rad, "rad", 0, 4,
       "An association is given up if its two features are turned against each other by more than this."},
  };
  return all;
}

const StageFields<TrackingOptions>& fields_of(const TrackingOptions&) {
  using O = TrackingOptions;
  static const StageFields<O> all = {
      {"evidence_memory", &O::evidence_memory, "", 0, 1,
       "Share of its gathered evidence that a hypothesis keeps at each new scan that is a whole piece of evidence. 1: "
       "nothing is forgotten."},
      {"prior_position", &O::prior_position, "", 0, kUnlimited,
       "How firmly a hypothesis stays at the position that dead reckoning gives when a scan is aligned to the map. It "
       "is a weight against that of each point of the scan. 0: the scan alone decides."},
      {"prior_heading", &O::prior_heading, "", 0, kUnlimited,
       "How firmly a hypothesis keeps the heading that dead reckoning gives when a scan is aligned to the map. It is "
       "a weight against that of each point of the scan. 0: the scan alone decides."},
      {"pose_memory", &O::pose_memory, "", 0, 1,
       "Share of what earlier scans tell about the pose that is kept at each new scan that is a whole piece of "
       "evidence. 0: the newest scan alone gives the pose."},
  };
  return all;
}

const StageFields<HypothesesOptions>& fields_of(const HypothesesOptions&) {
  using O = HypothesesOptions;
  static const StageFields<O> all = {
      {"spawn_nat", &O::spawn_nat, "nat", -kUnlimited, kUnlimited,
       "Evidence that a new hypothesis begins with: its log prior against clutter."},
      {"prune_nat", &O::prune_nat, "nat", 0, kUnlimited,
       "A hypothesis ends if it has so much less evidence than the best one. localized_lead of the stage status may "
       "raise this limit."},
      {"max_hypotheses", &O::max_hypotheses, "", 1, kUnlimited,
       "Most hypotheses that are kept, best first. The others end."},
      {"compared_places", &O::compared_places, "", 0, 100,
       "So many of the best places are compared with each other by those beams that must end elsewhere at one of the "
       "two. 0: none."},
  };
  return all;
}

}  // namespace opal
