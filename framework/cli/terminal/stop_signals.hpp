#pragma once

#include <signal.h>

#include <stop_token>
#include <thread>

/// Turns the first Ctrl-C (or SIGTERM) into a request to stop; the second one kills the program, as usual. To be made
/// before other threads are, which then leave these signals to it.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  std::stop_token token() const { return requested_.get_token(); }

 private:
  void wait(std::stop_token over);

  std::stop_source requested_;
  sigset_t signals_{}, before_{};
  std::jthread thread_;
};
