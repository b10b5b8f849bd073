#include "cli/terminal/live_view.hpp"

#include "viewer/html/page.hpp"

#include <condition_variable>
#include <iostream>
#include <mutex>

namespace opal::cli {

LiveView::LiveView(int port, std::stop_token stop, RecordWindow window)
    : stop_(std::move(stop)), records_(window), server_(live_page("/events"), records_, port) {
  std::cout << "watch it at " << url() << " (on this machine only; Ctrl-C ends the run)" << std::endl;
}

void LiveView::end() {
  feed_.end();
  if (stop_.stop_requested()) return;
  std::cout << "the log is over; " << url() << " stays until Ctrl-C" << std::endl;
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any().wait(lock, stop_, [] { return false; });
}

}  // namespace opal::cli
