#include <opal/live/live_localizer.hpp>

#include "common/task_queue.hpp"
#include "live/live_core.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace opal {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_of(Clock::time_point time) { return std::chrono::duration<double>(time.time_since_epoch()).count(); }

/// What the localizing thread is to take.
struct Task {
  LogRecord record;
  double received_s;
  double now_s;

  /// What somebody says makes way for nothing that sensors say.
  std::size_t kind() const {
    const bool is_said = std::holds_alternative<HintRecord>(record) || std::holds_alternative<ForgetRecord>(record);
    return is_said ? record.index() : 0;
  }
};

}  // namespace

struct LiveLocalizer::State {
  State(LocalizerParts parts, const LiveOptions& options, EventSink* events)
      : core(std::move(parts), options, events), tasks(options.most_queued, &Task::kind) {}

  void work(const std::stop_token& stop);
  void publish(LiveAnswer answer, const Task& task);

  LiveCore core;  ///< touched by the thread only
  TaskQueue<Task> tasks;

  mutable std::mutex mutex;  ///< of all below
  mutable std::condition_variable_any changed;
  LiveAnswer newest;
  std::vector<HealthFinding> health;
  std::map<std::string, int> counts;

  std::jthread thread;  ///< last: it ends before what it uses
};

/// The time in which the answer was found is part of its latency.
void LiveLocalizer::State::publish(LiveAnswer answer, const Task& task) {
  answer.latency_s += seconds_of(Clock::now()) - task.received_s;
  {
    const std::lock_guard lock(mutex);
    newest = std::move(answer);
  }
  changed.notify_all();
}

/// Health is judged once a while though nothing comes.
void LiveLocalizer::State::work(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kHealthEvery(200);
  while (!stop.stop_requested()) {
    if (const std::optional<Task> task = tasks.next(stop, kHealthEvery))
      core.take(task->record, task->received_s, task->now_s,
                [&](LiveAnswer answer) { publish(std::move(answer), *task); });
    std::vector<HealthFinding> now = core.health(seconds_of(Clock::now()));
    const int dropped = tasks.dropped();
    const std::lock_guard lock(mutex);
    health = std::move(now);
    counts = core.counts();
    if (dropped > 0) counts["dropped from a full queue"] = dropped;
  }
}

LiveLocalizer::LiveLocalizer(LocalizerParts parts, const LiveOptions& options, EventSink* events)
    : state_(std::make_unique<State>(std::move(parts), options, events)) {
  state_->thread = std::jthread([state = state_.get()](const std::stop_token& stop) { state->work(stop); });
}

LiveLocalizer::~LiveLocalizer() = default;

void LiveLocalizer::take(LogRecord record, double now_s) {
  state_->tasks.give({std::move(record), seconds_of(Clock::now()), now_s});
}

LiveAnswer LiveLocalizer::newest() const {
  const std::lock_guard lock(state_->mutex);
  LiveAnswer answer = state_->newest;
  answer.health = state_->health;
  return answer;
}

std::optional<LiveAnswer> LiveLocalizer::newer_than(std::uint64_t number, double timeout_s) const {
  std::unique_lock lock(state_->mutex);
  const bool is_there = state_->changed.wait_for(lock, std::chrono::duration<double>(timeout_s),
                                                 [&] { return state_->newest.number > number; });
  return is_there ? std::optional(state_->newest) : std::nullopt;
}

bool LiveLocalizer::drain(double timeout_s) const { return state_->tasks.drain(timeout_s); }

std::map<std::string, int> LiveLocalizer::counts() const {
  const std::lock_guard lock(state_->mutex);
  return state_->counts;
}

}  // namespace opal
