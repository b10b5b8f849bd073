#pragma once

#include <opal/sensing/log_source.hpp>

#include <string>

namespace opal::carmen_log {

/// Logs in the text format of CARMEN's logger, plain or gzip-compressed.
class CarmenLog final : public LogSource {
 public:
  /// @param laser_message  the message to take scans from; empty: of those in the first part of the log, the first of
  ///        FLASER, ROBOTLASER1, RAWLASER1, RLASER.
  /// @throws ConfigError if it is no laser message.
  explicit CarmenLog(std::string laser_message);

  bool recognizes(const std::string& path) const override;
  std::unique_ptr<LogReader> open(const std::string& path) const override;

 private:
  std::string laser_message_;
};

}  // namespace opal::carmen_log
