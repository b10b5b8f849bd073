#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace opal {

/// Tasks of one thread, given by others that wait for nobody. Bounded, each kind of task by itself: when it is full,
/// the oldest task of the kind makes way.
template <class Task>
class TaskQueue {
 public:
  using Kind = std::function<std::size_t(const Task&)>;

  /// @param most  tasks of one kind.
  /// @param kind  empty: all are of one.
  explicit TaskQueue(std::size_t most, Kind kind = {}) : most_(most), kind_(std::move(kind)) {}

  void give(Task task) {
    {
      const std::lock_guard lock(mutex_);
      if (tasks_.size() >= most_) make_way_for(task);
      tasks_.push_back(std::move(task));
    }
    changed_.notify_all();
  }

  /// The oldest task. The thread is busy with it until it asks for another one.
  /// @return nullopt if the thread is to end, or nothing has come for so long.
  std::optional<Task> next(const std::stop_token& stop, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    is_busy_ = false;
    changed_.notify_all();
    changed_.wait_for(lock, stop, patience, [this] { return !tasks_.empty(); });
    if (stop.stop_requested() || tasks_.empty()) return std::nullopt;
    is_busy_ = true;
    Task task = std::move(tasks_.front());
    tasks_.pop_front();
    return task;
  }

  /// Waits until all that was given so far is done. @return false if the time is up.
  bool drain(double timeout_s) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double>(timeout_s),
                             [this] { return tasks_.empty() && !is_busy_; });
  }

  int dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
  }

 private:
  void make_way_for(const Task& task) {
    const auto is_alike = [&](const Task& other) { return !kind_ || kind_(other) == kind_(task); };
    if (static_cast<std::size_t>(std::count_if(tasks_.begin(), tasks_.end(), is_alike)) < most_) return;
    const auto oldest = std::find_if(tasks_.begin(), tasks_.end(), is_alike);
    if (oldest == tasks_.end()) return;
    tasks_.erase(oldest);
    ++dropped_;
  }

  std::size_t most_;
  Kind kind_;
  mutable std::mutex mutex_;  ///< of all below
  std::condition_variable_any changed_;
  std::deque<Task> tasks_;
  bool is_busy_ = false;
  int dropped_ = 0;
};

}  // namespace opal
