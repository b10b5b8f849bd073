#include "ros2/service_notice.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

namespace opal::ros2 {

ServiceNotice::ServiceNotice(std::string address) : address_(std::move(address)) {
  if (!address_.empty()) socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
}

ServiceNotice::~ServiceNotice() {
  if (socket_ >= 0) close(socket_);
}

void ServiceNotice::send(const std::string& text) const {
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  if (socket_ < 0 || address_.size() >= sizeof to.sun_path) return;
  std::copy(address_.begin(), address_.end(), to.sun_path);
  if (address_[0] == '@') to.sun_path[0] = '\0';  // an abstract address
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + address_.size());
  sendto(socket_, text.data(), text.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&to), length);
}

AliveMeanwhile::AliveMeanwhile(ServiceNotice& notice, double every_s)
    : thread_([this, &notice, every = std::chrono::duration<double>(every_s)](const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        while (!stop.stop_requested()) {
          notice.alive();
          stopped_.wait_for(lock, stop, every, [] { return false; });
        }
      }) {}

}  // namespace opal::ros2
