#pragma once

#include <opal/localization/scoring/hypothesis.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/localization/scoring/score.hpp>

namespace opal {

/// Judges one hypothesis. Pure: same arguments, same score. Called from the localizer's thread only, for some
/// hundred hypotheses per scan, so it should take microseconds and allocate nothing per beam.
class OPAL_EXPORT HypothesisScorer {
 public:
  virtual ~HypothesisScorer();
  /// The robot under this hypothesis stands at hypothesis.T_map_local * observation.local_map.T_local_base().
  virtual Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map) const = 0;

  /// Whether a score depends on Hypothesis::associations. A candidate is ranked with those by which it was found, and spawned
  /// with what the scan alone says of it: a scorer that says no is asked once for both.
  virtual bool judges_associations() const;

  /// What the score of the same arguments rests on, most weighty first; a few findings at most, all of them facts about
  /// this scan. Asked only when somebody listens to the event stream, for the best hypothesis and for those that end.
  virtual std::vector<Finding> explain(const Hypothesis& hypothesis, const Observation& observation,
                                       const MapView& map) const;
};

}  // namespace opal
