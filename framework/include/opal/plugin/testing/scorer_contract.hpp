#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>
#include <opal/map/semantic_map.hpp>
#include <opal/plugin/registrar.hpp>

#include <memory>
#include <string>
#include <vector>

namespace opal::testing {

/// A synthetic building of two rooms with a doorway and columns, 14 m by 8 m, perceivable by "PlanarLidar2D".
OPAL_EXPORT std::shared_ptr<const SemanticMap> example_map();

/// What a scorer is tried on.
struct ScorerTrial {
  std::shared_ptr<const SemanticMap> map;  ///< null: example_map()
  std::string sensor = "PlanarLidar2D";    ///< that perceives the map
  std::vector<Pose2> T_map_base;           ///< where the robot stands in turn; empty: places in example_map()
  /// How much a score may change when map and registration are moved together: maps are looked up in grids,
  /// which do not turn with them [nat].
  double rigid_tolerance_nat = 0.5;
};

/// What every scorer promises (hypothesis_scorer.hpp): finite scores with a named breakdown, whether the
/// hypothesis is right, wrong or far outside the map, and whether the observation is rich or empty; the same
/// arguments give the same score, also among many in one call; map and registration moved together give that score too.
/// A scorer with a memory also promises: a copy is equal and independent, a score leaves the memory as it is, and
/// `remember` and `fade` do not throw and keep scores finite. A scorer without one returns nothing in Score::seen.
/// `score` gets no memory only if `new_memory` gives none.
/// @return violations, one sentence each; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> scorer_violations(const HypothesisScorer& scorer, const TypeInfo& type,
                                                       const ScorerTrial& trial = {});

}  // namespace opal::testing
