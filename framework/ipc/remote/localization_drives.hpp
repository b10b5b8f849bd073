#pragma once

#include "ipc/remote/localization_messages.hpp"
#include "navigation/localization_queries.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace opal::remote {

/// The drives that a program localizes, one after the other. Calls may come from any thread.
class LocalizationDrives {
 public:
  using Maker = std::function<std::unique_ptr<Localizer>(const LaserModel&)>;
  explicit LocalizationDrives(Maker make);

  /// Another drive with another localizer. @return its name, by which its scans are known.
  std::string begin(const LaserModel& laser);
  /// @return nullopt if the scan is of another drive than the one that was begun last.
  /// @throws ConfigError for a scan that is not later than the one before.
  std::optional<Answer> take(const ScanMessage& message);
  /// Tells this program from the one that was here before it ended.
  const std::string& run() const { return run_; }

 private:
  const Maker make_;
  const std::string run_;
  std::mutex mutex_;
  int drives_ = 0;
  std::string session_;
  std::unique_ptr<Localizer> localizer_;
  std::optional<navigation::LocalizerQueries> queries_;
  std::optional<double> newest_s_;
};

}  // namespace opal::remote
