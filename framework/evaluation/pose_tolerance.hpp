#pragma once

#include "common/pose_tolerance.hpp"

namespace opal {

/// How far a pose may be off the truth and still be right. Every success, false positive and summary judges a pose by
/// this.
inline constexpr PoseTolerance kRightPose{1.0, radians(10)};
/// What is called "strict".
inline constexpr PoseTolerance kStrictlyRightPose{0.5, radians(5)};

}  // namespace opal
