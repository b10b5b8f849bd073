#pragma once

#include <signal.h>

#include <atomic>
#include <stop_token>
#include <thread>

namespace opal::cli {

/// Turns the first Ctrl-C (or SIGTERM) into a request to stop; the second one kills the program, as usual. To be made
/// before other threads are, which then leave these signals to it.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  std::stop_token token() const { return requested_.get_token(); }
  int signal() const { return signal_; }  ///< that asked to stop; 0: none has

 private:
  void wait(const std::stop_token& over);

  std::stop_source requested_;
  std::atomic<int> signal_{0};
  sigset_t signals_{}, before_{};
  std::jthread thread_;
};

}  // namespace opal::cli
