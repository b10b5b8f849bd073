#pragma once

#include <opal/local_map/local_map.hpp>

#include <deque>
#include <vector>

namespace opal {

/// The keyframe of that id, which must exist.
const Keyframe& keyframe_of(const std::deque<Keyframe>& keyframes, KeyframeId id);

/// The feature that its measurements describe from the present poses of their keyframes, in frame `local`: the
/// weighted mean of points, corners and circles; for segments the line through all pieces, as long as they reach.
OPAL_EXPORT Feature estimate(const std::vector<Measurement>& measurements, const std::deque<Keyframe>& keyframes,
                             const LocalMapOptions& options);

/// Brings feature, distinct_poses, stable and last_keyframe in line with the measurements, which must not be empty.
void refresh(LocalFeature& local, const std::deque<Keyframe>& keyframes, const LocalMapOptions& options);

/// Joins local features that have turned out to be pieces of one; the smaller id keeps all measurements.
/// @param renamed  ids of detections (last_associations), changed along.
void merge_pieces(std::vector<LocalFeature>& features, std::vector<LocalFeatureId>& renamed,
                  const std::deque<Keyframe>& keyframes, const LocalMapOptions& options);

}  // namespace opal
