#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <string>

namespace opal {

/// The records of a run (page/README.md) as they are made: one thread appends, any number of threads read, each at its
/// own pace. Records are never removed or changed, so a reader may begin with the first one at any time.
class RecordLog {
 public:
  void append(std::string record);
  /// No more records come.
  void end();

  struct Reading {
    enum class Outcome { record, end, timeout, stopped } outcome;
    const std::string* record = nullptr;  ///< lives as long as the log
  };
  /// Waits for the record at a position, counted from 0.
  Reading wait(std::size_t position, const std::stop_token& stop, std::chrono::milliseconds patience) const;

  std::size_t size() const;

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable_any grown_;
  std::deque<std::string> records_;
  bool ended_ = false;
};

}  // namespace opal
