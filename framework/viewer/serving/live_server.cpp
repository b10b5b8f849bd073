#include "viewer/serving/live_server.hpp"

#include "ipc/loopback/loopback_http.hpp"

#include <fmt/format.h>

#include <atomic>
#include <charconv>

namespace opal {
namespace {

using namespace std::chrono_literals;
using httplib::Request;
using httplib::Response;

constexpr auto kHeartbeat = 10s;  ///< shows a connection that is gone while nothing happens

}  // namespace

struct LiveServer::Implementation {
  Implementation(std::string page_text, const RecordLog& log) : page(std::move(page_text)), records(log) {}

  void configure();
  void stop();
  void open_stream(const Request& request, Response& response);
  std::size_t resume_position(const std::string& last_event_id) const;
  bool write_next(std::size_t& position, httplib::DataSink& sink) const;

  const std::string page;
  const RecordLog& records;
  const std::string token = run_token();  ///< so that a browser that comes back to another run is not given its middle
  std::atomic<int> streams = 0;
  std::stop_source stopping;
  LoopbackServer server;
};

void LiveServer::Implementation::configure() {
  constexpr int kThreadsForPages = 4;
  httplib::Server& http = server.http;
  server.guard_pages(kMostStreams + kThreadsForPages, 1024, [](const Request& request, Response& response) {
    if (request.method == "GET") return false;
    answer(response, 405, "This server only shows.");
    return true;
  });
  http.Get("/", [this](const Request&, Response& response) { response.set_content(page, "text/html; charset=utf-8"); });
  http.Get("/events", [this](const Request& request, Response& response) { open_stream(request, response); });
}

void LiveServer::Implementation::stop() {
  stopping.request_stop();
  server.stop();
}

void LiveServer::Implementation::open_stream(const Request& request, Response& response) {
  if (streams.fetch_add(1) >= kMostStreams) {
    --streams;
    response.set_header("Retry-After", "5");
    return answer(response, 503, "Too many pages look at this run.");
  }
  const auto position = std::make_shared<std::size_t>(resume_position(request.get_header_value("Last-Event-ID")));
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, position](std::size_t, httplib::DataSink& sink) { return write_next(*position, sink); },
      [this](bool) { --streams; });
}

/// Events have ids "TOKEN.POSITION"; whatever is not ours begins with the first one.
std::size_t LiveServer::Implementation::resume_position(const std::string& last_event_id) const {
  const std::string ours = token + ".";
  if (!last_event_id.starts_with(ours)) return 0;
  const char* const end = last_event_id.data() + last_event_id.size();
  std::size_t last = 0;
  const auto parsed = std::from_chars(last_event_id.data() + ours.size(), end, last);
  return parsed.ec == std::errc() && parsed.ptr == end && last < records.size() ? last + 1 : 0;
}

bool LiveServer::Implementation::write_next(std::size_t& position, httplib::DataSink& sink) const {
  using Outcome = RecordLog::Reading::Outcome;
  const auto write = [&](const std::string& text) { return sink.write(text.data(), text.size()); };
  const RecordLog::Reading reading = records.wait(position, stopping.get_token(), kHeartbeat);
  switch (reading.outcome) {
    case Outcome::record:
      position = reading.position + 1;
      return write("id: " + token + "." + std::to_string(reading.position) + "\ndata: " + *reading.record + "\n\n");
    case Outcome::timeout: return write(":\n\n");
    case Outcome::stopped: return false;
    case Outcome::end: break;
  }
  const bool written = write("event: end\ndata: {}\n\n");
  sink.done();
  return written;
}

LiveServer::LiveServer(std::string page, const RecordLog& records, int port)
    : implementation_(std::make_unique<Implementation>(std::move(page), records)) {
  implementation_->configure();
  implementation_->server.listen(port, "choose another port with --serve=PORT");
}

LiveServer::~LiveServer() { implementation_->stop(); }

int LiveServer::port() const { return implementation_->server.port(); }
std::string LiveServer::url() const { return fmt::format("http://127.0.0.1:{}/", port()); }
int LiveServer::streams() const { return implementation_->streams; }

}  // namespace opal
