#pragma once

#include "plugin/testing/violations.hpp"

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <string>

namespace opal::testing {

/// What a scorer is asked in one trial of its memory. All of it outlives the trial.
struct MemoryQuestion {
  const HypothesisScorer& scorer;
  std::string name;  ///< of the hypothesis, for messages
  const Hypothesis& hypothesis;
  const Observation& seen;
  const MapView& view;
};

/// The laws of memory (hypothesis_scorer.hpp, scorer_memory.hpp). Hypotheses branch by copies: a copy must be equal,
/// and what one branch remembers must not reach the other. Trial poses are scored and dropped: a score must not change
/// the memory.
void check_memory(const MemoryQuestion& question, Violations& violations);

/// Whether two scores say the same.
bool same_score(const Score& a, const Score& b);

}  // namespace opal::testing
