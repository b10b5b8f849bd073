#pragma once

#include <string>

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

}  // namespace opal::ros2
