#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>

namespace opal::benchmark {

/// Makes a recorded log come at its own speed, or faster, or as fast as can be.
class Pace {
 public:
  /// @param speed  1: real time; 0: never wait. @param stop  ends a wait.
  Pace(double speed, std::stop_token stop) : speed_(speed), stop_(std::move(stop)) {}

  /// Waits until it is time for a scan with this stamp; the first one sets the clock, and so does one that lies before
  /// the one before it. Whoever is late catches up. @return false if stopped.
  bool wait_for(double stamp_s) {
    if (stop_.stop_requested()) return false;
    if (speed_ <= 0) return true;
    if (!start_ || stamp_s < newest_stamp_s_) {
      start_ = Clock::now();
      first_stamp_s_ = stamp_s;
    }
    newest_stamp_s_ = stamp_s;
    const std::chrono::duration<double> due((stamp_s - first_stamp_s_) / speed_);
    std::unique_lock lock(mutex_);
    stopped_.wait_until(lock, stop_, *start_ + std::chrono::duration_cast<Clock::duration>(due), [] { return false; });
    return !stop_.stop_requested();
  }

 private:
  using Clock = std::chrono::steady_clock;
  double speed_;
  std::stop_token stop_;
  std::optional<Clock::time_point> start_;
  double first_stamp_s_ = 0, newest_stamp_s_ = 0;
  std::mutex mutex_;
  std::condition_variable_any stopped_;
};

}  // namespace opal::benchmark
