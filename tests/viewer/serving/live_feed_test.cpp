#include "tests/viewer/synthetic_run.hpp"

#include "event_stream_client.hpp"

#include "viewer/encoding/page_encoder.hpp"
#include "viewer/reading/event_text.hpp"
#include "viewer/reading/frame_builder.hpp"
#include "viewer/serving/live_feed.hpp"
#include "viewer/serving/live_server.hpp"
#include "viewer/words/explanation.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <sstream>

using namespace opal;

namespace {

const synthetic::RunSize kRun{.updates = 60, .hypotheses = 30, .time_lines = 2};

/// Records of the run as they come from its event file.
std::vector<std::string> records_of_file(const synthetic::RunSize& size) {
  std::ostringstream file;
  JsonLinesSink events(file);
  synthetic::write_run(size, events);
  std::istringstream lines(file.str());
  FrameBuilder builder;
  PageEncoder encoder;
  std::optional<Explainer> explainer;
  std::vector<std::string> records;
  for (std::string line; std::getline(lines, line);) {
    const auto frame = builder.add(parse_event(line));
    if (!explainer && builder.header()) {
      explainer.emplace(*builder.header());
      records = {encoder.run_record(*builder.header()), encoder.map_record(*builder.header())};
    }
    if (!frame) continue;
    explainer->take(*frame);
    records.push_back(encoder.frame_record(*frame, words_of(explainer->explanation())));
  }
  return records;
}

std::vector<std::string> all_of(const RecordLog& log) {
  std::vector<std::string> records;
  for (std::size_t k = 0; k < log.size(); ++k) records.push_back(*log.wait(k, {}, std::chrono::milliseconds(0)).record);
  return records;
}

}  // namespace

TEST_CASE("a live run gives the records that its event file gives, with the same words") {
  RecordLog log;
  LiveFeed feed(log);
  synthetic::write_run(kRun, feed);
  feed.end();
  const auto live = all_of(log), from_file = records_of_file(kRun);
  CHECK(live.size() == 62);
  CHECK(live == from_file);
  CHECK(log.wait(live.size(), {}, std::chrono::milliseconds(0)).outcome == RecordLog::Reading::Outcome::end);
}

TEST_CASE("a clock that is set back does not end the page of a live run") {
  /// The clock of a robot that learns the time after 30 updates.
  struct SetBack final : EventSink {
    explicit SetBack(EventSink& taker) : to(taker) {}
    bool listening() const override { return true; }
    void write(const nlohmann::ordered_json& event) override {
      nlohmann::ordered_json changed = event;
      if (event.value("keyframe", 0) >= 30) changed["stamp_s"] = event["stamp_s"].get<double>() - 10;
      to.write(changed);
    }
    EventSink& to;
  };
  RecordLog log;
  LiveFeed feed(log);
  SetBack clock(feed);
  synthetic::write_run({.updates = 60, .hypotheses = 30, .time_lines = 1}, clock);
  feed.end();
  CHECK(all_of(log).size() == 62);
}

TEST_CASE("the words of a live run stand in its records") {
  RecordLog log;
  LiveFeed feed(log);
  synthetic::write_run(kRun, feed);
  feed.end();
  const auto record = nlohmann::json::parse(all_of(log).back());
  REQUIRE(record.contains("words"));
  CHECK(record["words"][0][0] == "answer");
}

TEST_CASE("a number that is none, which the event file writes as null, does not stop the feed") {
  RecordLog log;
  LiveFeed feed(log);
  class Spoiling final : public EventSink {
   public:
    explicit Spoiling(EventSink& to) : to_(to) {}
    bool listening() const override { return true; }
    void write(const nlohmann::ordered_json& event) override {
      nlohmann::ordered_json spoilt = event;
      if (spoilt["event"] == "estimate") spoilt["hypotheses"][0]["scan_nat"] = -std::numeric_limits<double>::infinity();
      to_.write(spoilt);
    }

   private:
    EventSink& to_;
  } spoiling(feed);
  synthetic::write_run(kRun, spoiling);
  CHECK_NOTHROW(feed.end());
  CHECK(log.size() == 62);
}

TEST_CASE("over hours a feed with a window keeps as much as after minutes, and who comes late can read it") {
  constexpr double kUpdatesASecond = 4;
  RecordLog log({.seconds = 60});
  LiveFeed feed(log);
  std::size_t most_early = 0, most_late = 0, updates = 0;
  class Watching final : public EventSink {
   public:
    Watching(EventSink& to, std::function<void()> updated) : to_(to), updated_(std::move(updated)) {}
    bool listening() const override { return true; }
    void write(const nlohmann::ordered_json& event) override {
      to_.write(event);
      if (event["event"] == "cost") updated_();
    }

   private:
    EventSink& to_;
    std::function<void()> updated_;
  } watching(feed, [&] {
    log.wait(2 + updates++, {}, std::chrono::seconds(10));  // in step: nothing waits in the queue
    std::size_t& most = updates < 600 * kUpdatesASecond ? most_early : most_late;
    most = std::max(most, log.bytes());
  });
  synthetic::write_run({.updates = 2 * 3600 * 4, .hypotheses = 4, .points = 10}, watching);
  feed.end();
  CHECK(log.size() == 2 + 2 * 3600 * 4);
  CHECK(static_cast<double>(most_late) < 1.2 * static_cast<double>(most_early));
  const auto map = log.wait(1, {}, std::chrono::milliseconds(0));
  const auto oldest = log.wait(map.position + 1, {}, std::chrono::milliseconds(0));
  const double kept_s = static_cast<double>(log.size() - oldest.position) / kUpdatesASecond;
  CHECK(kept_s >= 60);
  CHECK(kept_s <= 60 + 2 * 60. / 8 + 1);
  const auto record = nlohmann::json::parse(*oldest.record);
  CHECK(record["restated"]["path"][0].size() > 100);
  CHECK(nlohmann::json::parse(*log.wait(0, {}, std::chrono::milliseconds(0)).record)["window"]["seconds"] == 60);
}

TEST_CASE("events after one that is not understood are not kept") {
  RecordLog log;
  LiveFeed feed(log);
  feed.write({{"event", "keyframe"}});
  log.wait(0, {}, std::chrono::seconds(10));  // the log has ended
  synthetic::write_run(kRun, feed);
  CHECK(log.size() == 0);
  CHECK_THROWS_AS(feed.end(), EventError);
}

TEST_CASE("an event that is not understood ends the log and is told at the end") {
  RecordLog log;
  LiveFeed feed(log);
  feed.write({{"event", "keyframe"}});
  synthetic::write_run(kRun, feed);
  CHECK_THROWS_AS(feed.end(), EventError);
  CHECK(log.wait(0, {}, std::chrono::milliseconds(0)).outcome == RecordLog::Reading::Outcome::end);
}

TEST_CASE("a feed that is dropped in the middle of a run ends the log") {
  RecordLog log;
  {
    LiveFeed feed(log);
    synthetic::write_run({.updates = 400, .hypotheses = 100}, feed);
  }
  CHECK(log.wait(log.size(), {}, std::chrono::milliseconds(0)).outcome == RecordLog::Reading::Outcome::end);
}

TEST_CASE("a browser gets a whole run while another one stalls") {
  RecordLog log;
  const LiveServer server("page", log, 0);
  const StalledClient stalled(server.port());
  EventStreamClient reader(server.port());
  LiveFeed feed(log);
  synthetic::write_run({.updates = 300, .hypotheses = 100, .points = 300}, feed);
  feed.end();
  const auto messages = reader.wait_for_end();
  REQUIRE(messages.size() == 303);
  CHECK(messages.front().data.starts_with("{\"r\":\"run\""));
  CHECK(messages.back().kind == "end");
}
