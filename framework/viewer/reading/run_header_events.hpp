#pragma once

#include "viewer/reading/event_place.hpp"
#include "viewer/reading/run_frame.hpp"

#include "sensing/trajectory.hpp"

#include <string>
#include <unordered_map>
#include <vector>

namespace opal {

/// Positions of mapped features by their id.
using FeaturePositions = std::unordered_map<std::string, MapFeatureNumber>;

/// What the events that stand once per run say. All throw EventError (event_place.hpp).
void read_run_event(const EventPlace& event, RunHeader& header);
FeaturePositions read_map_event(const EventPlace& event, RunHeader& header);
std::vector<StampedPose> read_truth_event(const EventPlace& event);

/// Position of the mapped feature that this id names.
MapFeatureNumber mapped_feature(const EventPlace& id, const FeaturePositions& positions);

}  // namespace opal
