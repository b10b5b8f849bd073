#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <memory>
#include <string>

namespace opal {

/// What becomes of a scorer's scores.
enum class ScorerRole {
  decides,  ///< they take part in the decision
  observes  ///< they are recorded, and change nothing
};

/// A scorer as a deployment runs it.
struct ActiveScorer {
  std::string name;                              ///< by which its scores are known
  std::shared_ptr<const HypothesisScorer> part;  ///< the scorer itself
  ScorerRole role = ScorerRole::decides;         ///< whether it decides
  double weight = 1;                             ///< its scores are multiplied by this in the decision

  bool decides() const { return role == ScorerRole::decides; }  ///< its scores take part in the decision
};

}  // namespace opal
