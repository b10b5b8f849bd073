#pragma once

#include <opal/hypothesis.hpp>
#include <opal/map_view.hpp>
#include <opal/score.hpp>

namespace opal {

/// Judges one hypothesis. Pure: same arguments, same score. Called from the localizer's thread only, for some
/// hundred hypotheses per scan, so it should take microseconds and allocate nothing per beam.
class OPAL_EXPORT HypothesisScorer {
 public:
  virtual ~HypothesisScorer();
  /// The robot under this hypothesis stands at hypothesis.T_map_local * observation.local_map.T_local_base().
  virtual Score score(const Hypothesis& hypothesis, const Observation& observation, const MapView& map) const = 0;
};

}  // namespace opal
