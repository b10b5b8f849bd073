#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace opal {

/// How much of a run is kept for those who watch it. Usually all of it.
struct RecordWindow {
  double seconds = std::numeric_limits<double>::infinity();     ///< of the run,
  std::size_t bytes = std::numeric_limits<std::size_t>::max();  ///< or of records, whichever is less

  bool bounds_seconds() const;
  bool bounds_bytes() const;
  bool is_bounded() const { return bounds_seconds() || bounds_bytes(); }
  /// Whether so much fills the window.
  bool is_filled_by(double of_seconds, std::size_t of_bytes) const;
};

/// The records of a run (page/README.md) as they are made: one thread appends, any number of threads read, each at its
/// own pace. Records never change. With a window the oldest are dropped: what is left begins, after the first records,
/// with one that a reader can begin with, and holds at least the window.
class RecordLog {
 public:
  explicit RecordLog(RecordWindow window = {}) : window_(window) {}

  enum class Kind {
    follows,  ///< means something only after the one before
    begins,   ///< says all that a reader has to know, after the first records
    first     ///< is for every reader, and is never dropped: before all others
  };
  /// @param run_s  how much of the run there was when the record was made; it never decreases.
  void append(std::string record, Kind kind = Kind::follows, double run_s = 0);
  /// No more records come.
  void end();

  struct Reading {
    enum class Outcome { record, end, timeout, stopped } outcome;
    std::shared_ptr<const std::string> record = {};
    std::size_t position = 0;  ///< of the record
  };
  /// Waits for the record at a position, counted from 0. If it was dropped, the reader is given the first record of
  /// all; one that has just read the first records goes on with the oldest that is left.
  Reading wait(std::size_t position, const std::stop_token& stop, std::chrono::milliseconds patience) const;

  const RecordWindow& window() const { return window_; }
  /// How many there were in all.
  std::size_t size() const;
  /// What is kept.
  std::size_t bytes() const;

 private:
  struct Kept {
    std::shared_ptr<const std::string> text;
    Kind kind;
    double run_s;
    std::size_t bytes_before;  ///< of all records before it, also of those that were dropped
  };
  void drop_oldest();
  std::size_t next_beginning() const;
  std::size_t size_now() const { return first_.size() + dropped_ + kept_.size(); }
  Reading at(std::size_t position) const;

  const RecordWindow window_;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any grown_;
  std::deque<std::shared_ptr<const std::string>> first_;
  std::deque<Kept> kept_;    ///< after the first ones
  std::size_t dropped_ = 0;  ///< records between the first ones and what is kept
  std::size_t bytes_ = 0;    ///< of all, also of those that were dropped
  std::size_t first_bytes_ = 0;
  bool ended_ = false;
};

}  // namespace opal
