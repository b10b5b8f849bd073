#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <memory>
#include <string>

namespace opal {

/// A scorer as a deployment runs it.
struct ActiveScorer {
  std::string name;                              ///< by which its scores are known
  std::shared_ptr<const HypothesisScorer> part;  ///< the scorer itself
  bool decides = true;                           ///< false: observes, its scores are recorded and change nothing
  double weight = 1;                             ///< its scores are multiplied by this in the decision
};

}  // namespace opal
