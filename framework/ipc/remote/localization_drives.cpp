#include "ipc/remote/localization_drives.hpp"

#include "ipc/loopback/loopback_http.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

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
  session_ = fmt::format("{}.{}", run_, ++drives_);
  return session_;
}

std::optional<Answer> LocalizationDrives::take(const ScanMessage& message) {
  const std::lock_guard lock(mutex_);
  if (!queries_ || message.session != session_) return std::nullopt;
  if (newest_s_ && message.scan.stamp_s <= *newest_s_)
    throw ConfigError(fmt::format("scan: /stamp_s: {:f}, expected more than that of the scan before, {:f}",
                                  message.scan.stamp_s, *newest_s_));
  if (message.keep_pattern) queries_->keep_pattern();
  queries_->take(message.scan);
  newest_s_ = message.scan.stamp_s;
  return Answer{queries_->estimate(), queries_->pattern()};
}

}  // namespace opal::remote
