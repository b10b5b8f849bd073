#include "ros2/service_notice.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>

using namespace opal::ros2;

namespace {

/// A service manager that counts what it hears.
class Manager {
 public:
  explicit Manager(const std::string& path) : socket_(socket(AF_UNIX, SOCK_DGRAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::copy(path.begin(), path.end(), address.sun_path);
    REQUIRE(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  }
  ~Manager() { close(socket_); }

  std::string hear() const {
    char text[100];
    const ssize_t length = recv(socket_, text, sizeof text, 0);
    return {text, static_cast<std::size_t>(std::max<ssize_t>(0, length))};
  }

 private:
  int socket_;
};

}  // namespace

TEST_CASE("while a large map is made ready, the service manager hears again and again that the program is alive") {
  const TemporaryFolder folder;
  const Manager manager(folder.path_of("notify"));
  ServiceNotice notice(folder.path_of("notify"));
  {
    const AliveMeanwhile alive(notice, 0.01);
    for (int k = 0; k < 5; ++k) CHECK(manager.hear() == "WATCHDOG=1");
  }
  notice.ready();
  std::string heard = manager.hear();
  while (heard == "WATCHDOG=1") heard = manager.hear();
  CHECK(heard == "READY=1");
}
