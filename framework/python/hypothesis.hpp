#pragma once

#include <opal/localization/scoring/hypothesis.hpp>

namespace opal::python {

/// A hypothesis as it was at a keyframe.
struct HypothesisHandle {
  Hypothesis hypothesis;
  Pose2 T_map_base;  ///< at that keyframe
};

}  // namespace opal::python
