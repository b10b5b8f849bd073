#include "ipc/loopback/loopback_http.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <random>

namespace opal {
namespace {

/// The library's own choice, SO_REUSEPORT, would let two programs share one port.
void reuse_address_only(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

int bind_to_loopback(httplib::Server& server, int port, const std::string& advice) {
  server.set_socket_options(reuse_address_only);
  if (port == 0)
    port = server.bind_to_any_port(kLoopback);
  else if (!server.bind_to_port(kLoopback, port))
    throw Error(
        fmt::format("{}:{}: cannot be listened on, most likely another program does; {}", kLoopback, port, advice));
  if (port < 0) throw Error(std::string(kLoopback) + ": no port is free");
  return port;
}

bool is_from_here(const httplib::Request& request, int port) {
  if (request.get_header_value_count("Host") != 1) return false;
  const std::string host = request.get_header_value("Host"), suffix = fmt::format(":{}", port);
  for (const char* name : {kLoopback, "localhost", "[::1]"}) {
    if (host != name + suffix) continue;
    return !request.has_header("Origin") || request.get_header_value("Origin") == "http://" + host;
  }
  return false;
}

httplib::Headers page_headers() {
  return {{"Content-Security-Policy",
           "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; "
           "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
          {"X-Content-Type-Options", "nosniff"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Referrer-Policy", "no-referrer"},
          {"Cache-Control", "no-store"}};
}

std::string run_token() {
  std::random_device device;
  return fmt::format("{}-{}", device(), device());
}

void answer(httplib::Response& response, int status, const std::string& sentence) {
  response.status = status;
  response.set_content(sentence + "\n", "text/plain; charset=utf-8");
}

}  // namespace opal
