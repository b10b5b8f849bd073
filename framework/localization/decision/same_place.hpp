#pragma once

#include "common/pose_tolerance.hpp"

namespace opal {

/// What an answer takes for one place: hypotheses there share their probability. Misplaced walls leave hypotheses of
/// one place this far apart, and an alternative is somewhere else. PoseEstimate and docs/events.md tell the numbers.
inline constexpr PoseTolerance kSamePlace{0.7, 0.2};

}  // namespace opal
