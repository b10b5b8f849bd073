#pragma once

#include "viewer/reading/run_frame.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace opal {

/// Gets the frames of a run in order. @return whether to go on reading.
using FrameVisitor = std::function<bool(const RunHeader&, RunFrame&&)>;

/// What there is to say about a recording besides its frames.
struct RunReading {
  std::shared_ptr<const RunHeader> header;
  std::size_t frames = 0;          ///< visited
  std::vector<std::string> notes;  ///< sentences: what is missing at the end of a run that was killed
};

/// The event file of a run.
/// @param out  the folder that `opal localize -o` wrote, or the file itself. @throws EventError if there is
/// none.
std::string event_file(const std::string& out);

/// Reads a run, frame by frame; holds one at a time. A last line that is cut off is a note, not an error.
/// @param out  as for event_file
/// @throws EventError "FILE:LINE: what was found, what was expected".
RunReading read_run(const std::string& out, const FrameVisitor& visit);

}  // namespace opal
