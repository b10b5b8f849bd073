#pragma once

#include <opal/local_map/local_map.hpp>

#include <deque>
#include <vector>

namespace opal {

/// Driving between two poses [m], a turn counted as the options have it.
double driven_between_m(const Pose2& a, const Pose2& b, const LocalMapOptions& options);

/// Whether the newest keyframe differs enough from the one before it to be kept next to it.
bool newest_is_distinct(const std::deque<Keyframe>& keyframes, const LocalMapOptions& options);

/// Removes the keyframe before the newest one, with its measurements, if `superseded`, and all keyframes and
/// measurements beyond the horizon; features without measurements go, others that lost some are estimated anew.
void forget(std::deque<Keyframe>& keyframes, std::vector<LocalFeature>& features, bool superseded,
            const LocalMapOptions& options);

}  // namespace opal
