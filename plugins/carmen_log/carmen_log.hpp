#pragma once

#include <opal/sensing/log_source.hpp>

#include <string>
#include <vector>

namespace opal::carmen_log {

/// Logs in the text format of CARMEN's logger, plain or gzip-compressed.
class CarmenLog final : public LogSource {
 public:
  /// @param laser_messages  the messages to take scans from, one a laser, with spaces between them; empty: of those in
  ///        the first part of the log, the first of FLASER, ROBOTLASER1, RAWLASER1, RLASER.
  /// @throws ConfigError if one is no laser message.
  explicit CarmenLog(const std::string& laser_messages);

  bool recognizes(const std::string& path) const override;
  std::unique_ptr<LogReader> open(const std::string& path) const override;

 private:
  std::vector<std::string> laser_messages_;
};

}  // namespace opal::carmen_log
