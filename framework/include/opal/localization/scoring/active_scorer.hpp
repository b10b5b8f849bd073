#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <memory>
#include <string>

namespace opal {

/// A scorer as a deployment runs it.
struct ActiveScorer {
  std::string name;
  std::shared_ptr<const HypothesisScorer> part;
  bool decides = true;  ///< false: observes, its scores are recorded and change nothing
  double weight = 1;
};

}  // namespace opal
