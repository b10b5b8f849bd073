#pragma once

#include "viewer/reading/run_reader.hpp"

#include <functional>
#include <string>

namespace opal {

/// A moment of a run, as people name it.
struct Moment {
  enum class Clock { since_start, stamp, end };
  Clock clock = Clock::end;
  double seconds = 0;  ///< since the start of the time line, or the stamp
  std::string query;   ///< name of the time line; empty: the first one, or the last one if the clock is `end`
};

/// @param text  "12.5" since the start of the time line [s], "stamp:1626.25" of the log [s], or "end".
/// @throws Error that says what was found and expected.
Moment parse_moment(const std::string& text, const std::string& query);

/// Reads a run up to a moment: `take` gets every frame that comes before it, the last one being the newest that is not
/// after it. Frames of other time lines may come first; whoever follows frames forgets those when a frame starts a new
/// one.
/// @throws EventError as read_run does, and if the run has no such time line, or the moment is outside of what it
/// holds.
RunReading read_until(const std::string& out, const Moment& moment,
                      const std::function<void(const RunHeader&, const RunFrame&)>& take);

}  // namespace opal
