#include "cli/terminal/stop_signals.hpp"

#include <condition_variable>
#include <mutex>

namespace opal::cli {

StopSignals::StopSignals() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  thread_ = std::jthread([this](const std::stop_token& over) { wait(over); });
}

StopSignals::~StopSignals() {
  thread_.request_stop();
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void StopSignals::wait(const std::stop_token& over) {
  constexpr timespec kPatience{0, 100'000'000};  // how long the program's end may take longer for this thread
  while (!over.stop_requested()) {
    const int signal = sigtimedwait(&signals_, nullptr, &kPatience);
    if (signal < 0) continue;
    signal_ = signal;
    requested_.request_stop();
    break;
  }
  // From now on a signal does what it usually does: this thread takes it.
  pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait(lock, over, [] { return false; });
}

}  // namespace opal::cli
