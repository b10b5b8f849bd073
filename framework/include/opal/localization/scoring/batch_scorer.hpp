#pragma once

#include <opal/localization/scoring/hypothesis_scorer.hpp>

#include <span>
#include <vector>

namespace opal {

/// A scorer that judges many hypotheses in one call, where a call is dear or the hypotheses can share work. A scorer
/// implements it beside HypothesisScorer. Only for scorers without a memory.
class OPAL_EXPORT BatchScorer {
 public:
  virtual ~BatchScorer();

  /// What HypothesisScorer::score gives for each of them.
  /// @param hypotheses   none of them null; may be empty.
  /// @param observation  what the robot sees now.
  /// @param map          the map that the hypotheses refer to.
  /// @return as many scores, in the same order.
  virtual std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses, const Observation& observation,
                                       const MapView& map) const = 0;
};

/// The same for a scorer that remembers. A scorer may implement both; which is asked depends on whether new_memory
/// gave it a memory.
class OPAL_EXPORT RememberingBatchScorer {
 public:
  virtual ~RememberingBatchScorer();

  /// What HypothesisScorer::score gives for each of them with its memory.
  /// @param hypotheses   none of them null; may be empty.
  /// @param memories     of the hypotheses, in the same order; none of them null, and the same one may come several
  /// times.
  /// @param observation  what the robot sees now.
  /// @param map          the map that the hypotheses refer to.
  /// @return as many scores, in the same order.
  virtual std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses,
                                       std::span<const ScorerMemory* const> memories, const Observation& observation,
                                       const MapView& map) const = 0;
};

}  // namespace opal
