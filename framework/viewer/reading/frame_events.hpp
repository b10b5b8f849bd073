#pragma once

#include "viewer/reading/run_header_events.hpp"

namespace opal {

/// Whether events of this kind say something about an update that a frame holds (docs/events.md, "Once per
/// update").
bool is_frame_event(const std::string& kind);

/// Reads such an event into the frame. @throws EventError (event_place.hpp).
/// @param features  ids of mapped features that events may name
void read_frame_event(const std::string& kind, const EventPlace& event, const FeaturePositions& features,
                      RunFrame& frame);

}  // namespace opal
