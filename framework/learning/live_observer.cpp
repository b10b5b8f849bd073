#include "learning/live_observer.hpp"

#include "common/task_queue.hpp"

#include <opal/common/warning.hpp>
#include <opal/sensing/scan_pairing.hpp>

#include <thread>
#include <utility>

namespace opal {

struct LiveObserver::State {
  State(const LocalizerParts& parts, std::string drive_given, Listener heard_given, std::size_t most_queued)
      : pairing(parts.lasers),
        observer(parts),
        drive(std::move(drive_given)),
        heard(std::move(heard_given)),
        records(most_queued) {}

  // Touched by the thread only.
  ScanPairing pairing;
  DriveObserver observer;
  std::string drive;
  Listener heard;
  int parts_told = 0;

  TaskQueue<LogRecord> records;
  std::jthread thread;  ///< last: it ends before what it uses

  std::string next_name() { return drive + ", part " + std::to_string(parts_told + 1); }

  void tell(const DriveEvidence& evidence) {
    if (evidence.visits.empty()) return;
    ++parts_told;
    heard(evidence);
  }

  void watch(const LogRecord& record) {
    pairing.take(record);
    while (const std::optional<Sample> sample = pairing.next()) {
      observer.update(*sample);
      if (const auto evidence = observer.take(next_name())) tell(*evidence);
    }
  }

  /// Whatever goes wrong here, the robot is localized all the same.
  template <class Step>
  static void try_to(const Step& step) {
    try {
      step();
    } catch (const std::exception& error) {
      warn(std::string("learning: ") + error.what() + ": what these visits have taught is lost");
    }
  }

  void work(const std::stop_token& stop) {
    constexpr std::chrono::milliseconds kPatience(1000);
    while (!stop.stop_requested())
      if (const std::optional<LogRecord> record = records.next(stop, kPatience)) try_to([&] { watch(*record); });
    try_to([&] { tell(observer.finish(next_name())); });
  }
};

LiveObserver::LiveObserver(const LocalizerParts& parts, std::string drive, Listener heard, std::size_t most_queued)
    : state_(std::make_unique<State>(parts, std::move(drive), std::move(heard), most_queued)) {
  state_->thread = std::jthread([state = state_.get()](const std::stop_token& stop) { state->work(stop); });
}

LiveObserver::~LiveObserver() = default;

void LiveObserver::take(LogRecord record) { state_->records.give(std::move(record)); }

bool LiveObserver::drain(double timeout_s) { return state_->records.drain(timeout_s); }

}  // namespace opal
