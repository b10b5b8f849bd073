#pragma once

#include <optional>
#include <string>

namespace opal {

/// Name of the file that marks a folder whose run has not finished.
inline constexpr const char* kUnfinishedMarker = "unfinished.json";

/// What the marker in a folder says about the run that writes there, or wrote there.
struct UnfinishedRun {
  std::string command;  ///< "opal localize"
  long process = 0;
  std::string host;
  std::string since;        ///< UTC, ISO 8601
  std::string ending;       ///< "was interrupted (SIGINT)"; empty while nothing is known
  bool is_running = false;  ///< the lock is held

  /// "opal localize (process 7 on robot, since 2026-01-01T10:00:00Z)"
  std::string who() const;
};

/// Reads a marker's text; whatever is missing in it stays empty.
UnfinishedRun parse_unfinished_run(const std::string& text);
/// One JSON object and a line's end.
std::string text_of(const UnfinishedRun& run);
/// This process, from now on.
UnfinishedRun this_run(const std::string& command);

/// The run of a folder that is not finished; nullopt if the folder has no marker.
std::optional<UnfinishedRun> unfinished_run(const std::string& folder);

/// A note for readers of a folder: "this run was not finished: opal localize (...) was interrupted (SIGINT)"; empty if
/// the folder has no marker.
std::string unfinished_note(const std::string& folder);

}  // namespace opal
