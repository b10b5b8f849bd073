#include "mcap_log.hpp"

#include <opal/common/error.hpp>
#include <opal/recording/mcap_recording.hpp>

namespace opal::mcap_log {

bool McapLog::recognizes(const std::string& path) const {
  try {
    const std::vector<std::string> files = recording::files_of_recording(path, ".mcap");
    return !files.empty() && recording::is_mcap(files.front());
  } catch (const std::exception&) {
    return false;
  }
}

recording::Parts McapLog::parts_of(const std::string& path) const {
  recording::Parts parts;
  for (const std::string& file : recording::files_of_recording(path, ".mcap"))
    parts.push_back(recording::read_mcap(file));
  if (parts.empty()) throw LogError(path + ": a folder without .mcap files, expected an MCAP recording");
  return parts;
}

}  // namespace opal::mcap_log
