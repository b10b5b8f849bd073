#pragma once

#include <opal/localization/observation/observation.hpp>
#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/localization/scoring/score.hpp>
#include <opal/map/view/map_view.hpp>

#include <memory>
#include <span>
#include <vector>

namespace opal {

/// Judges one hypothesis. Pure: same arguments, same score. Called from the localizer's thread only, for some
/// hundred hypotheses per scan, so it should take microseconds and allocate nothing per beam.
///
/// A scorer may remember what a hypothesis has met, since seeing the same thing again is hardly new evidence. The
/// framework keeps the memory: a hypothesis carries it, a branch begins with a copy, and a hypothesis that ends drops
/// it. Only the scorer that made a memory reads and changes it.
class OPAL_EXPORT HypothesisScorer {
 public:
  virtual ~HypothesisScorer();

  /// What is remembered of a hypothesis that has met nothing yet. Asked once for each map; every hypothesis begins with
  /// a copy. Null, the default: this scorer remembers nothing; `remember` and `fade` are not called.
  virtual std::unique_ptr<ScorerMemory> new_memory(const MapView& map) const;

  /// The robot under this hypothesis stands at observation.T_map_base(hypothesis.T_map_local).
  /// @param hypothesis   what is judged: its registration and its associations.
  /// @param observation  what the robot sees now.
  /// @param map          the map that the hypothesis refers to.
  /// @param memory       of this hypothesis, made by this scorer; null if and only if new_memory gives null.
  virtual Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map,
                      const ScorerMemory* memory) const = 0;

  /// What `score` gives for each of them; this is what the framework calls. By default `score` is called for one after
  /// the other. A scorer overrides it where a call is dear, or where hypotheses can share work. If it throws, it
  /// contributes nothing to any of them.
  /// @param hypotheses   none of them null; never empty.
  /// @param memories     of the hypotheses, in the same order, as for `score`; the same one may come several times.
  /// @param observation  what the robot sees now.
  /// @param map          the map that the hypotheses refer to.
  /// @return as many scores, in the same order.
  virtual std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses,
                                       std::span<const ScorerMemory* const> memories, const Observation& observation,
                                       const MapView& map) const;

  /// `score` for a hypothesis that has met nothing yet.
  Score score_new(const Hypothesis& hypothesis, const Observation& observation, const MapView& map) const;

  /// Adds to a memory what one scan has shown (Score::seen).
  /// @param memory  what this scorer made; it is changed.
  /// @param seen    Score::seen of that scan.
  /// @param weight  share of a whole, independent piece of evidence that the scan is, in (0, 1].
  virtual void remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const;

  /// Lets a memory fade as one more scan is tracked; called before `remember`, not in retrospective verification.
  /// @param memory  what this scorer made; it is changed.
  /// @param weight  as for `remember`.
  virtual void fade(ScorerMemory& memory, double weight) const;

  /// Whether a score depends on Hypothesis::associations. A candidate is ranked with those by which it was found, and
  /// begins with what the scan alone says of it: a scorer that says no is asked once for both.
  virtual bool judges_associations() const;

  /// What speaks against the hypothesis by the same arguments, most weighty first: the framework tells the first three.
  /// All of them are facts about this scan. Asked only when somebody listens to the event stream, for the best
  /// hypothesis and for those that end.
  virtual std::vector<Finding> explain(const Hypothesis& hypothesis, const Observation& observation,
                                       const MapView& map) const;
};

}  // namespace opal
