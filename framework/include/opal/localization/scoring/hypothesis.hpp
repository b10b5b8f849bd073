#pragma once

#include <opal/common/geometry.hpp>
#include <opal/localization/scoring/scorer_memory.hpp>

#include <string>
#include <vector>

namespace opal {

/// One symbolic statement: local feature -> map feature, or -> not on the map.
struct Association {
  int local_feature = -1;  ///< LocalFeature::id
  int map_feature = -1;    ///< position in SemanticMap::features(); -1: not on the map
};

/// One answer to "where am I": a set of associations, and the registration that they imply.
struct Hypothesis {
  int id = 0;                             ///< unique over a run; never reused
  Pose2 T_map_local;                      ///< registration of the local map
  std::vector<Association> associations;  ///< along the branch of the association tree, root first
  double log_likelihood = 0;              ///< evidence gathered so far [nat], against "all of this is clutter"
  ScorerMemories memories;                ///< what scorers remember of it
};

}  // namespace opal
