#pragma once

#include <httplib.h>

#include <string>
#include <thread>

namespace opal {

/// What servers for this machine only have in common.
constexpr const char* kLoopback = "127.0.0.1";

/// Whether a request names this machine and does not come from a web page elsewhere, which may have its own
/// name point here (DNS rebinding).
bool is_from_here(const httplib::Request& request, int port);

/// Headers of a page and of all that it gets: it may run what stands in it and talk to this server, nothing else;
/// nobody may frame it, and nothing is kept.
httplib::Headers page_headers();

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

  httplib::Server http;  ///< what it answers; to be said before `listen`

  /// @param port  0: any free one. @param advice  what to do if it cannot be had, for the message.
  /// @throws Error if it cannot be had.
  void listen(int port, const std::string& advice);
  void stop();  ///< after `listen`
  int port() const { return port_; }

  /// Answers a request that is not from here. @return whether it was one.
  bool refuses(const httplib::Request& request, httplib::Response& response) const;

 private:
  int port_ = 0;
  std::thread thread_;
};

}  // namespace opal
