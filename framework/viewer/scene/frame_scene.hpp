#pragma once

#include "viewer/reading/run_state.hpp"

#include "drawing/drawing.hpp"

namespace opal {

/// The picture of a moment: the map with everything that the newest frame and what led to it say.
/// @param notes  sentences beside it. @throws MapError if the recording's map is none that can be drawn.
DrawingScene scene_of(const RunHeader& header, const RunState& state, const std::vector<std::string>& notes);

}  // namespace opal
