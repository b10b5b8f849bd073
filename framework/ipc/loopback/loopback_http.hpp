#pragma once

#include <httplib.h>

#include <functional>
#include <string>
#include <thread>

namespace opal {

/// What servers for this machine only have in common.
constexpr const char* kLoopback = "127.0.0.1";

/// Whether a request names this machine and does not come from a web page elsewhere, which may have its own
/// name point here (DNS rebinding).
bool is_from_here(const httplib::Request& request, int port);

/// Tells the runs of a server apart.
std::string run_token();

/// A sentence.
void answer(httplib::Response& response, int status, const std::string& sentence);

/// A server with a thread of its own, on a port of 127.0.0.1 that no other program listens on.
class LoopbackServer {
 public:
  LoopbackServer() = default;
  LoopbackServer(const LoopbackServer&) = delete;
  LoopbackServer& operator=(const LoopbackServer&) = delete;

  /// Answers a request that it does not like. @return whether it was one.
  using Refusal = std::function<bool(const httplib::Request&, httplib::Response&)>;

  httplib::Server http;  ///< what it answers; to be said before `listen`

  /// Refuses what is too large, what is not from here, and what `also` refuses; to be said before `listen`.
  void guard(std::size_t threads, std::size_t most_bytes, Refusal also = {});
  /// The same for a server of pages: an idle browser holds no thread.
  void guard_pages(std::size_t threads, std::size_t most_bytes, Refusal also = {});

  /// @param port  0: any free one. @param advice  what to do if it cannot be had, for the message.
  /// @throws Error if it cannot be had.
  void listen(int port, const std::string& advice);
  void stop();  ///< after `listen`
  int port() const { return port_; }

 private:
  int port_ = 0;
  std::thread thread_;
};

}  // namespace opal
