#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace opal::ros2 {

/// Tells systemd how this program is (sd_notify(3)); nobody is told if it was started otherwise.
class ServiceNotice {
 public:
  /// @param address  NOTIFY_SOCKET; empty: nobody listens.
  explicit ServiceNotice(std::string address);
  ~ServiceNotice();
  ServiceNotice(const ServiceNotice&) = delete;
  ServiceNotice& operator=(const ServiceNotice&) = delete;

  void ready() { send("READY=1"); }
  /// Still alive; to be said more often than WatchdogSec.
  void alive() { send("WATCHDOG=1"); }
  void stopping() { send("STOPPING=1"); }
  /// What `systemctl status` shows.
  void status(const std::string& words) { send("STATUS=" + words); }

 private:
  void send(const std::string& text) const;

  std::string address_;
  int socket_ = -1;
};

/// Says that the program is alive while it does one thing that takes long, as it must not be ended for.
class AliveMeanwhile {
 public:
  /// @param notice  must outlive it; others may use it meanwhile. @param every_s  less than WatchdogSec.
  explicit AliveMeanwhile(ServiceNotice& notice, double every_s = 1);

 private:
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace opal::ros2
