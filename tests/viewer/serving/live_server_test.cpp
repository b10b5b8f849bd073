#include "event_stream_client.hpp"

#include <opal/common/error.hpp>

#include "viewer/serving/live_server.hpp"

#include <catch2/catch.hpp>

#include <httplib.h>

#include <optional>

using namespace opal;
using Catch::Matchers::Contains;

namespace {

std::string record(std::size_t number) { return "{\"r\":\"frame\",\"keyframe\":" + std::to_string(number) + "}"; }

void append(RecordLog& log, std::size_t from, std::size_t to) {
  for (std::size_t k = from; k < to; ++k) log.append(record(k));
}

void check_records(const std::vector<Message>& messages, std::size_t from, std::size_t to) {
  REQUIRE(messages.size() >= to - from);
  for (std::size_t k = from; k < to; ++k) {
    CHECK(messages[k - from].data == record(k));
    CHECK(messages[k - from].kind == "message");
  }
}

void wait_for_streams(const LiveServer& server, int count) {
  while (server.streams() != count) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Status of `GET path` with other headers than a browser on this machine would send.
int status_of(const LiveServer& server, const std::string& path, const httplib::Headers& headers) {
  httplib::Client client("127.0.0.1", server.port());
  const auto result = client.Get(path, headers);
  REQUIRE(result);
  return result->status;
}

}  // namespace

TEST_CASE("who joins late gets all records from the first one on, and then those that come") {
  RecordLog log;
  append(log, 0, 50);
  const LiveServer server("page", log, 0);
  EventStreamClient early(server.port());
  check_records(early.wait_for(50), 0, 50);
  append(log, 50, 70);
  EventStreamClient late(server.port());
  check_records(late.wait_for(70), 0, 70);
  check_records(early.wait_for(70), 0, 70);
}

TEST_CASE("the stream ends with an event that says so") {
  RecordLog log;
  append(log, 0, 3);
  const LiveServer server("page", log, 0);
  EventStreamClient during(server.port());
  during.wait_for(3);
  log.end();
  EventStreamClient after(server.port());
  for (EventStreamClient* client : {&during, &after}) {
    const auto messages = client->wait_for_end();
    REQUIRE(messages.size() == 4);
    check_records(messages, 0, 3);
    CHECK(messages.back().kind == "end");
  }
}

TEST_CASE("a browser that comes back goes on where it was") {
  RecordLog log;
  append(log, 0, 30);
  log.end();
  const LiveServer server("page", log, 0);
  const std::vector<Message> all = EventStreamClient(server.port()).wait_for_end();
  REQUIRE(all.size() == 31);
  const std::size_t seen = GENERATE(0, 11, 29);
  const auto rest = EventStreamClient(server.port(), {{"Last-Event-ID", all[seen].id}}).wait_for_end();
  CHECK(rest.size() == 31 - seen - 1);
  check_records(rest, seen + 1, 30);
  CHECK(rest.back().kind == "end");
}

TEST_CASE("a browser that comes back after what it lacks was dropped begins anew, with what is left") {
  RecordLog log({.seconds = 10});
  log.append("run", RecordLog::Kind::first);
  const auto append_second = [&](int s) {
    log.append(record(static_cast<std::size_t>(s)), s % 5 == 0 ? RecordLog::Kind::begins : RecordLog::Kind::follows, s);
  };
  for (int s = 0; s < 5; ++s) append_second(s);
  const LiveServer server("page", log, 0);
  const std::string seen = EventStreamClient(server.port()).wait_for(6).at(3).id;
  for (int s = 5; s < 100; ++s) append_second(s);
  log.end();
  const auto rest = EventStreamClient(server.port(), {{"Last-Event-ID", seen}}).wait_for_end();
  CHECK(rest.front().data == "run");
  check_records({rest.begin() + 1, rest.end()}, 85, 100);
  const auto at_once = EventStreamClient(server.port(), {{"Last-Event-ID", rest[4].id}}).wait_for_end();
  check_records(at_once, 89, 100);
}

TEST_CASE("a browser that comes back to another run begins anew") {
  RecordLog log, other;
  append(log, 0, 30);
  append(other, 0, 30);
  log.end();
  other.end();
  const LiveServer server("page", log, 0), other_server("page", other, 0);
  const std::string of_other = EventStreamClient(other_server.port()).wait_for_end().at(20).id;
  const std::string of_this = EventStreamClient(server.port()).wait_for_end().at(20).id;
  for (const std::string& id : {of_other, of_this + "9", of_this + "x", std::string("20"), std::string("-1")}) {
    CAPTURE(id);
    check_records(EventStreamClient(server.port(), {{"Last-Event-ID", id}}).wait_for_end(), 0, 30);
  }
}

TEST_CASE("the page is served, with headers that keep others away from it") {
  RecordLog log;
  const LiveServer server("<!doctype html>the page", log, 0);
  httplib::Client client("127.0.0.1", server.port());
  const auto page = client.Get("/");
  REQUIRE(page);
  CHECK(page->status == 200);
  CHECK(page->body == "<!doctype html>the page");
  CHECK_THAT(page->get_header_value("Content-Type"), Contains("text/html"));
  CHECK_THAT(page->get_header_value("Content-Security-Policy"), Contains("default-src 'none'"));
  CHECK(page->get_header_value("X-Content-Type-Options") == "nosniff");
  CHECK_FALSE(page->has_header("Access-Control-Allow-Origin"));
}

TEST_CASE("there is nothing else to get") {
  RecordLog log;
  const LiveServer server("page", log, 0);
  for (const char* path : {"/index.html", "/events/1", "/../etc/passwd", "//etc/passwd", "/%2e%2e/etc/passwd"}) {
    CAPTURE(path);
    CHECK(status_of(server, path, {}) == 404);
  }
  httplib::Client client("127.0.0.1", server.port());
  CHECK(client.Post("/", "x", "text/plain")->status == 405);
  CHECK(client.Options("/events")->status == 405);
}

TEST_CASE("requests that name another host, or come from another origin, are refused") {
  RecordLog log;
  log.end();
  const LiveServer server("page", log, 0);
  const std::string port = std::to_string(server.port());
  for (const char* path : {"/", "/events"}) {
    CAPTURE(path);
    for (const std::string host : {"evil.example", "127.0.0.1", "localhost", "127.0.0.1:1", "localhost:80x", ""})
      CHECK(status_of(server, path, {{"Host", host}}) == 403);
    CHECK(status_of(server, path, {{"Host", "evil.example:" + port}}) == 403);
    CHECK(status_of(server, path, {{"Origin", "http://evil.example"}}) == 403);
    CHECK(status_of(server, path, {{"Origin", "null"}}) == 403);
    for (const std::string host : {"127.0.0.1:", "localhost:", "[::1]:"})
      CHECK(status_of(server, path, {{"Host", host + port}, {"Origin", "http://" + host + port}}) == 200);
  }
}

TEST_CASE("a client that never reads holds up neither the log nor other clients") {
  constexpr std::size_t kRecords = 2000;
  const std::string padding(16 << 10, 'x');  // 32 MB in all, far more than sockets buffer
  RecordLog log;
  const LiveServer server("page", log, 0);
  const StalledClient stalled(server.port());
  wait_for_streams(server, 1);
  for (std::size_t k = 0; k < kRecords; ++k) log.append("{\"r\":\"" + padding + "\"}");
  CHECK(log.size() == kRecords);
  EventStreamClient reader(server.port());
  CHECK(reader.wait_for(kRecords).size() == kRecords);
}

TEST_CASE("the server ends while clients wait, read and stall") {
  RecordLog log;
  append(log, 0, 5);
  auto server = std::make_optional<LiveServer>("page", log, 0);
  EventStreamClient waiting(server->port());
  waiting.wait_for(5);
  const StalledClient stalled(server->port());
  wait_for_streams(*server, 2);
  for (int k = 0; k < 1000; ++k) log.append("{\"r\":\"" + std::string(16 << 10, 'x') + "\"}");
  server.reset();
  const auto messages = waiting.wait_for_end();
  check_records(messages, 0, 5);
  CHECK(messages.back().kind == "message");  // the run was not at its end
}

TEST_CASE("one stream too many is told to try again later, and can when one has gone") {
  RecordLog log;
  append(log, 0, 1);
  const LiveServer server("page", log, 0);
  std::vector<std::unique_ptr<EventStreamClient>> clients;
  for (int k = 0; k < LiveServer::kMostStreams; ++k)
    clients.push_back(std::make_unique<EventStreamClient>(server.port()));
  wait_for_streams(server, LiveServer::kMostStreams);
  CHECK(EventStreamClient(server.port()).status() == 503);
  CHECK(status_of(server, "/", {}) == 200);
  clients.pop_back();
  append(log, 1, 3);  // writing to the one that has gone shows that it has
  wait_for_streams(server, LiveServer::kMostStreams - 1);
  EventStreamClient again(server.port());
  check_records(again.wait_for(3), 0, 3);
}

TEST_CASE("a port that is taken is an error that names it and says what to do") {
  RecordLog log;
  const LiveServer first("page", log, 0);
  CHECK_THROWS_WITH(LiveServer("page", log, first.port()),
                    Contains("127.0.0.1:" + std::to_string(first.port())) && Contains("--serve=PORT"));
}
