#include "viewer/serving/record_log.hpp"

#include <cmath>

namespace opal {

bool RecordWindow::bounds_seconds() const { return std::isfinite(seconds); }

bool RecordWindow::bounds_bytes() const { return bytes != std::numeric_limits<std::size_t>::max(); }

bool RecordWindow::is_filled_by(double of_seconds, std::size_t of_bytes) const {
  return of_seconds >= seconds || of_bytes >= bytes;
}

void RecordLog::append(std::string record, Kind kind, double run_s) {
  {
    std::lock_guard lock(mutex_);
    const std::size_t bytes = record.size();
    auto text = std::make_shared<const std::string>(std::move(record));
    if (kind == Kind::first) {
      first_.push_back(std::move(text));
      first_bytes_ += bytes;
    } else {
      kept_.push_back({std::move(text), kind, run_s, bytes_});
      bytes_ += bytes;
    }
    if (kind == Kind::begins) drop_oldest();
  }
  grown_.notify_all();
}

/// The next record after the oldest that a reader can begin with; one past the end if there is none.
std::size_t RecordLog::next_beginning() const {
  std::size_t next = 1;
  while (next < kept_.size() && kept_[next].kind != Kind::begins) ++next;
  return next;
}

void RecordLog::drop_oldest() {
  if (!window_.is_bounded()) return;
  for (std::size_t next = next_beginning(); next < kept_.size(); next = next_beginning()) {
    const Kept& begins = kept_[next];
    if (!window_.is_filled_by(kept_.back().run_s - begins.run_s, bytes_ - begins.bytes_before)) return;
    kept_.erase(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(next));
    dropped_ += next;
  }
}

void RecordLog::end() {
  {
    std::lock_guard lock(mutex_);
    ended_ = true;
  }
  grown_.notify_all();
}

RecordLog::Reading RecordLog::at(std::size_t position) const {
  const std::size_t oldest = first_.size() + dropped_;
  if (position == first_.size()) position = oldest;
  if (position < oldest && position > first_.size()) position = 0;
  const auto& text = position < first_.size() ? first_[position] : kept_[position - oldest].text;
  return {Reading::Outcome::record, text, position};
}

RecordLog::Reading RecordLog::wait(std::size_t position, const std::stop_token& stop,
                                   std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  grown_.wait_for(lock, stop, patience, [&] { return position < size_now() || ended_; });
  if (stop.stop_requested()) return {Reading::Outcome::stopped};
  if (position < size_now()) return at(position);
  return {ended_ ? Reading::Outcome::end : Reading::Outcome::timeout};
}

std::size_t RecordLog::size() const {
  std::lock_guard lock(mutex_);
  return size_now();
}

std::size_t RecordLog::bytes() const {
  std::lock_guard lock(mutex_);
  return first_bytes_ + (kept_.empty() ? 0 : bytes_ - kept_.front().bytes_before);
}

}  // namespace opal
