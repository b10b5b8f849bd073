#include "mcap_log.hpp"

#include <opal/recording/mcap_recording.hpp>

namespace opal::mcap_log {

bool McapLog::recognizes_file(const std::string& file) const { return recording::is_mcap(file); }

std::unique_ptr<recording::Recording> McapLog::read(const std::string& file) const {
  return recording::read_mcap(file);
}

}  // namespace opal::mcap_log
