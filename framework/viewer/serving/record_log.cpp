#include "viewer/serving/record_log.hpp"

namespace opal {

void RecordLog::append(std::string record) {
  {
    std::lock_guard lock(mutex_);
    records_.push_back(std::move(record));
  }
  grown_.notify_all();
}

void RecordLog::end() {
  {
    std::lock_guard lock(mutex_);
    ended_ = true;
  }
  grown_.notify_all();
}

RecordLog::Reading RecordLog::wait(std::size_t position, const std::stop_token& stop,
                                   std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  grown_.wait_for(lock, stop, patience, [&] { return position < records_.size() || ended_; });
  if (stop.stop_requested()) return {Reading::Outcome::stopped};
  if (position < records_.size()) return {Reading::Outcome::record, &records_[position]};
  return {ended_ ? Reading::Outcome::end : Reading::Outcome::timeout};
}

std::size_t RecordLog::size() const {
  std::lock_guard lock(mutex_);
  return records_.size();
}

}  // namespace opal
