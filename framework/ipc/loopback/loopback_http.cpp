#include "ipc/loopback/loopback_http.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <chrono>
#include <random>
#include <utility>

namespace opal {
namespace {

/// The library's own choice, SO_REUSEPORT, would let two programs share one port.
void reuse_address_only(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

int bound_port(httplib::Server& server, int port, const std::string& advice) {
  server.set_socket_options(reuse_address_only);
  if (port == 0)
    port = server.bind_to_any_port(kLoopback);
  else if (!server.bind_to_port(kLoopback, port))
    throw Error(
        fmt::format("{}:{}: cannot be listened on, most likely another program does; {}", kLoopback, port, advice));
  if (port < 0) throw Error(std::string(kLoopback) + ": no port is free");
  return port;
}

/// Of a page and of all that it gets: it may run what stands in it and talk to this server, nothing else; nobody may
/// frame it, and nothing is kept.
httplib::Headers page_headers() {
  return {{"Content-Security-Policy",
           "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; "
           "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
          {"X-Content-Type-Options", "nosniff"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Referrer-Policy", "no-referrer"},
          {"Cache-Control", "no-store"}};
}

}  // namespace

bool is_from_here(const httplib::Request& request, int port) {
  if (request.get_header_value_count("Host") != 1) return false;
  const std::string host = request.get_header_value("Host"), suffix = fmt::format(":{}", port);
  for (const char* name : {kLoopback, "localhost", "[::1]"}) {
    if (host != name + suffix) continue;
    return !request.has_header("Origin") || request.get_header_value("Origin") == "http://" + host;
  }
  return false;
}

std::string run_token() {
  std::random_device device;
  return fmt::format("{}-{}", device(), device());
}

void answer(httplib::Response& response, int status, const std::string& sentence) {
  response.status = status;
  response.set_content(sentence + "\n", "text/plain; charset=utf-8");
}

void LoopbackServer::guard(std::size_t threads, std::size_t most_bytes, Refusal also) {
  using Verdict = httplib::Server::HandlerResponse;
  http.new_task_queue = [threads] { return new httplib::ThreadPool(threads); };
  http.set_payload_max_length(most_bytes);
  http.set_pre_routing_handler(
      [this, also = std::move(also)](const httplib::Request& request, httplib::Response& response) {
        if (is_from_here(request, port_))
          return also && also(request, response) ? Verdict::Handled : Verdict::Unhandled;
        answer(response, 403, fmt::format("This server answers to {}:{} only.", kLoopback, port_));
        return Verdict::Handled;
      });
}

void LoopbackServer::guard_pages(std::size_t threads, std::size_t most_bytes, Refusal also) {
  guard(threads, most_bytes, std::move(also));
  http.set_keep_alive_max_count(1);
  http.set_default_headers(page_headers());
}

void LoopbackServer::listen(int port, const std::string& advice) {
  using namespace std::chrono_literals;
  port_ = bound_port(http, port, advice);
  thread_ = std::thread([this] { http.listen_after_bind(); });
  while (!http.is_running()) std::this_thread::sleep_for(1ms);  // until then it would not hear `stop`
}

void LoopbackServer::stop() {
  http.stop();
  thread_.join();
}

}  // namespace opal
