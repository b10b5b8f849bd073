#include "live_robot.hpp"

#include <opal/live/live_localizer.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

using namespace opal;

namespace {

/// A minute of records comes at once.
LiveOptions with_room() {
  LiveOptions options;
  options.most_queued = 100'000;
  return options;
}

/// What was written, told by the localizing thread.
struct Heard : EventSink {
  bool listening() const override { return true; }
  void write(const nlohmann::ordered_json& event) override { all.push_back(event); }
  std::vector<nlohmann::ordered_json> all;
};

}  // namespace

TEST_CASE("answers come from a thread of its own, numbered, the newest one first") {
  LiveLocalizer live(robot().parts(), with_room());
  for (const simulation::Arrival& arrival : robot().arrivals) live.take(arrival.record);
  REQUIRE(live.drain(60));
  const LiveAnswer newest = live.newest();
  CHECK(newest.number > 500);
  CHECK(newest.estimate.status == Status::localized);
  CHECK(distance_m(newest.estimate.T_map_base, robot().truth_at(newest.stamp_s)) < 0.5);
  CHECK_FALSE(live.newer_than(newest.number, 0.01));
  CHECK(live.newer_than(newest.number - 1, 0.01));
}

TEST_CASE("records from two threads are all worked on") {
  LiveLocalizer live(robot().parts(), with_room());
  const auto give = [&](bool scans) {
    for (const simulation::Arrival& arrival : robot().arrivals)
      if (std::holds_alternative<RawScan>(arrival.record) == scans) live.take(arrival.record);
  };
  { std::jthread odometry(give, false), scans(give, true); }
  REQUIRE(live.drain(60));
  CHECK(live.newest().number > 0);
}

TEST_CASE("a full queue drops the oldest records, counts them, and makes nobody wait") {
  LiveOptions options;
  options.most_queued = 20;
  LiveLocalizer live(robot().parts(), options);
  for (const simulation::Arrival& arrival : robot().arrivals) live.take(arrival.record);
  REQUIRE(live.drain(60));
  CHECK(live.counts().at("dropped from a full queue") > 0);
}

TEST_CASE("after a reset a live localizer starts anew") {
  Heard heard;
  LiveLocalizer live(robot().parts(), with_room(), &heard);
  for (const simulation::Arrival& arrival : robot().arrivals) live.take(arrival.record);
  REQUIRE(live.drain(60));
  heard.all.clear();
  live.reset();
  RawScan later = std::get<RawScan>(robot().arrivals[robot().arrivals.size() / 2].record.index() == 1
                                        ? robot().arrivals[robot().arrivals.size() / 2].record
                                        : robot().recording.scans.front().scan);
  later.stamp_s += 100;
  live.take(OdometryRecord{later.stamp_s - 0.01, Pose2()});
  live.take(later);
  live.take(OdometryRecord{later.stamp_s + 1, Pose2()});
  REQUIRE(live.drain(60));
  CHECK(live.newest().estimate.status != Status::localized);
  const auto keyframe = std::ranges::find_if(heard.all, [](const auto& event) { return event["event"] == "keyframe"; });
  REQUIRE(keyframe != heard.all.end());
  for (const auto& number : (*keyframe)["T_local_base"]) CHECK(number == 0);  // the first one of a local map
}

TEST_CASE("silence is told without any record") {
  LiveOptions options;
  options.silent_after_s = 0.2;
  LiveLocalizer live(robot().parts(), options);
  for (std::size_t k = 0; k < 40; ++k) live.take(robot().arrivals[k].record);
  REQUIRE(live.drain(60));
  std::this_thread::sleep_for(std::chrono::milliseconds(800));
  const std::vector<HealthFinding> health = live.newest().health;
  CHECK(std::ranges::any_of(
      health, [](const HealthFinding& finding) { return finding.words.find("no odometry for") != std::string::npos; }));
}

TEST_CASE(
    "an answer's latency is how long its scan waited and how long it took, and no more than the time that passed") {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  LiveLocalizer live(robot().parts(), with_room());
  for (std::size_t k = 0; k < 60; ++k) live.take(robot().arrivals[k].record);
  REQUIRE(live.drain(60));
  const LiveAnswer newest = live.newest();
  const double passed_s = std::chrono::duration<double>(Clock::now() - begun).count();
  REQUIRE(newest.number > 0);
  CHECK(newest.latency_s > newest.waited_s);
  CHECK(newest.waited_s >= 0);
  CHECK(newest.latency_s < passed_s);
}

TEST_CASE("who waits for an answer is woken by it") {
  using Clock = std::chrono::steady_clock;
  LiveLocalizer live(robot().parts(), with_room());
  Clock::time_point woken;
  std::optional<LiveAnswer> answer;
  std::jthread waiting([&] {
    answer = live.newer_than(0, 20);
    woken = Clock::now();
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const auto begun = Clock::now();
  for (std::size_t k = 0; k < 60; ++k) live.take(robot().arrivals[k].record);
  waiting.join();
  REQUIRE(answer);
  CHECK(answer->number > 0);
  CHECK(std::chrono::duration<double>(woken - begun).count() < 10);
}

TEST_CASE("a hint to a live localizer reaches it, and what is odd in its records is counted") {
  Heard heard;
  LiveLocalizer live(robot().parts(), with_room(), &heard);
  live.hint({robot().truth_at(0.2) * Pose2(0.3, -0.2, 0.1), 0.3, 0.15});
  for (std::size_t k = 0; k < 60; ++k)
    for (int copy = 0; copy < 2; ++copy) live.take(robot().arrivals[k].record);
  REQUIRE(live.drain(60));
  const LiveAnswer newest = live.newest();
  CHECK(distance_m(newest.estimate.T_map_base, robot().truth_at(newest.stamp_s)) < 0.5);
  CHECK_FALSE(newest.why.empty());
  CHECK(std::ranges::any_of(heard.all, [](const auto& event) { return event.value("origin", "") == "hint"; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // counts are published once a while
  const auto counts = live.counts();
  CHECK(
      std::ranges::any_of(counts, [](const auto& count) { return count.first.find("doubled") != std::string::npos; }));
}
