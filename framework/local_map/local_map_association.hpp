#pragma once

#include <opal/local_map/local_map.hpp>

#include <optional>
#include <vector>

namespace opal {

/// Whether two features (in one frame) can be views of one object, as the gates of `options` have it (thesis
/// Algorithm 1: eq_type, eq_dim, within_thres; A.1.1 for segments).
/// @return how far apart they are, as a share of the gates (0: equal, at most about 1); nullopt if they cannot be.
std::optional<double> association_cost(const Feature& a, const Feature& b, const LocalMapOptions& options);

/// Pairs detections with local features, best pairs first, so that the order of the detections does not matter.
/// Several detected segments may be pieces of one local segment; other local features take one detection each.
/// @param detections  in the frame of the local features.
/// @return for each detection the index of its local feature; -1: none.
std::vector<int> associate(const std::vector<Feature>& detections, const std::vector<LocalFeature>& local,
                           const LocalMapOptions& options);

}  // namespace opal
