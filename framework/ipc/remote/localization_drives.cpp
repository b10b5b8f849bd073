#include "ipc/remote/localization_drives.hpp"

#include "ipc/loopback/loopback_http.hpp"

#include <opal/common/error.hpp>

namespace opal::remote {

LocalizationDrives::LocalizationDrives(Maker make) : make_(std::move(make)), run_(run_token()) {}

std::string LocalizationDrives::begin(const LaserModel& laser) {
  const std::lock_guard lock(mutex_);
  auto localizer = make_(laser);  // before anything changes
  queries_.reset();
  localizer_ = std::move(localizer);
  queries_.emplace(*localizer_, laser);
  queries_->begin();
  newest_s_.reset();
  session_ = run_ + "." + std::to_string(++drives_);
  return session_;
}

std::optional<Answer> LocalizationDrives::take(const ScanMessage& message) {
  const std::lock_guard lock(mutex_);
  if (!queries_ || message.session != session_) return std::nullopt;
  if (newest_s_ && message.scan.stamp_s <= *newest_s_)
    throw ConfigError("scan: /stamp_s: " + std::to_string(message.scan.stamp_s) +
                      ", expected more than that of the scan before, " + std::to_string(*newest_s_));
  if (message.keep_pattern) queries_->keep_pattern();
  queries_->take(message.scan);
  newest_s_ = message.scan.stamp_s;
  return Answer{queries_->estimate(), queries_->pattern()};
}

}  // namespace opal::remote
