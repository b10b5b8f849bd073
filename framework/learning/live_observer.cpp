#include "learning/live_observer.hpp"

#include <opal/sensing/scan_pairing.hpp>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace opal {

struct LiveObserver::State {
  State(const LocalizerParts& parts, std::string drive_given, Listener heard_given, std::size_t most)
      : pairing(parts.lasers),
        observer(parts),
        drive(std::move(drive_given)),
        heard(std::move(heard_given)),
        most_queued(most) {}

  // Touched by the thread only.
  ScanPairing pairing;
  DriveObserver observer;
  std::string drive;
  Listener heard;
  int visits = 0;

  std::size_t most_queued;
  std::mutex mutex;  ///< of all below
  std::condition_variable_any changed;
  std::deque<LogRecord> queue;
  bool is_busy = false;

  std::jthread thread;  ///< last: it ends before what it uses

  std::string next_name() { return drive + ", visit " + std::to_string(visits + 1); }

  void tell(const DriveEvidence& evidence) {
    if (evidence.visits.empty()) return;
    ++visits;
    heard(evidence);
  }

  void watch(const LogRecord& record) {
    pairing.take(record);
    while (const std::optional<Sample> sample = pairing.next()) {
      observer.update(*sample);
      if (const auto evidence = observer.take(next_name())) tell(*evidence);
    }
  }

  /// @return nullopt if it is time to end.
  std::optional<LogRecord> next_record(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    is_busy = false;
    changed.notify_all();
    changed.wait(lock, stop, [this] { return !queue.empty(); });
    if (stop.stop_requested()) return std::nullopt;
    is_busy = true;
    LogRecord record = std::move(queue.front());
    queue.pop_front();
    return record;
  }

  void work(const std::stop_token& stop) {
    while (const std::optional<LogRecord> record = next_record(stop)) watch(*record);
    tell(observer.finish(next_name()));
  }
};

LiveObserver::LiveObserver(const LocalizerParts& parts, std::string drive, Listener heard, std::size_t most_queued)
    : state_(std::make_unique<State>(parts, std::move(drive), std::move(heard), most_queued)) {
  state_->thread = std::jthread([state = state_.get()](const std::stop_token& stop) { state->work(stop); });
}

LiveObserver::~LiveObserver() = default;

void LiveObserver::take(LogRecord record) {
  {
    const std::lock_guard lock(state_->mutex);
    if (state_->queue.size() >= state_->most_queued) state_->queue.pop_front();
    state_->queue.push_back(std::move(record));
  }
  state_->changed.notify_all();
}

bool LiveObserver::drain(double timeout_s) {
  std::unique_lock lock(state_->mutex);
  return state_->changed.wait_for(lock, std::chrono::duration<double>(timeout_s),
                                  [this] { return state_->queue.empty() && !state_->is_busy; });
}

}  // namespace opal
