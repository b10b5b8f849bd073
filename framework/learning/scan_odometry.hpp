#pragma once

#include "survey/pose_tracker.hpp"

#include <span>
#include <vector>

namespace opal {

/// The motion along samples as odometry and scan matching tell it, without a map: one keyframe per sample, the first of
/// which stands at `start`. Nothing is measured yet.
/// @param samples  in time order.
std::vector<TrackedKeyframe> scan_odometry(const LocalizerParts& parts, std::span<const Sample> samples,
                                           const Pose2& start);

}  // namespace opal
