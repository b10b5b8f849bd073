#pragma once

#include <opal/sensing/log_source.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace opal::carmen_log {

/// What one line of a CARMEN log turned out to be.
struct ParsedLine {
  std::optional<LogRecord> record;
  const char* defect = nullptr;  ///< why there is none, or what the record lacks; null for lines of no interest
};

/// Parses one line: ODOM, and the laser messages of the given names (FLASER, RLASER, ROBOTLASER1, RAWLASER1, ...).
/// @param terminated  false if the file ends before the line does; its last number is not to be trusted then.
ParsedLine parse_line(std::string_view text, bool terminated, std::span<const std::string> laser_messages);

/// The first word of a line.
std::string_view message_of(std::string_view text);
/// True for the messages that this program knows to be a laser's.
bool is_laser_message(std::string_view message);
/// True for any message that CARMEN's logger writes.
bool is_carmen_message(std::string_view message);

}  // namespace opal::carmen_log
