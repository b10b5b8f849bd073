#pragma once

#include <opal/common/geometry.hpp>
#include <opal/local_map/local_map_ids.hpp>
#include <opal/localization/scoring/scorer_memory.hpp>
#include <opal/map/map_numbers.hpp>

#include <string>
#include <vector>

namespace opal {

/// One symbolic statement: local feature -> map feature, or -> not on the map.
struct Association {
  LocalFeatureId local_feature = {};  ///< in the local map
  MapFeatureNumber map_feature = {};  ///< none: not on the map
};

struct Hypothesis;
using HypothesisId = Id<Hypothesis>;  ///< unique over a run; never reused

/// One answer to "where am I": a set of associations, and the registration that they imply.
struct Hypothesis {
  HypothesisId id = {};                   ///< none: it has not been spawned
  Pose2 T_map_local;                      ///< registration of the local map
  std::vector<Association> associations;  ///< along the branch of the association tree, root first
  double log_likelihood = 0;              ///< evidence gathered so far [nat], against "all of this is clutter"
  ScorerMemories memories;                ///< what scorers remember of it
};

}  // namespace opal
