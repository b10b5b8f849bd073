#pragma once

#include <opal/common/geometry.hpp>
#include <opal/localization/scoring/scorer_memory.hpp>
#include <opal/map/map_numbers.hpp>

#include <memory>
#include <string>
#include <vector>

namespace opal {

/// A scorer's opinion of one hypothesis. Opinions of several scorers add up; score and veto are separate.
struct Score {
  double log_likelihood = 0;  ///< contribution of this scan [nat]; > 0 speaks for the hypothesis
  std::string veto;           ///< not empty: the hypothesis must not survive, and this is why
  /// One summand, or a number that explains the score.
  struct Term {
    std::string name;  ///< the scorer's own word for it
    double value = 0;  ///< in the unit that the name says; [nat] without one
  };
  std::vector<Term> breakdown;                    ///< what it is made of, for people and for A/B records
  std::shared_ptr<const ScorerMemory> seen = {};  ///< what this scan adds to the scorer's memory; null: nothing
};

/// One thing that a scorer saw for or against a hypothesis, for people.
struct Finding {
  std::string words;                  ///< "beam 221 passes 1.82 m through Wall wall-12"
  MapFeatureNumber map_feature = {};  ///< none: it is about no feature
  std::vector<Point> line;            ///< where: two points in the `map` frame [m], or empty
};

}  // namespace opal
