#include "learning/live_observer.hpp"

#include "tests/live/live_robot.hpp"

#include <opal/sensing/scan_pairing.hpp>

#include <catch2/catch.hpp>

#include <mutex>

using namespace opal;

namespace {

/// What the visits of a drive say, one after the other.
std::vector<nlohmann::ordered_json> learned_live(std::size_t most_queued) {
  std::mutex mutex;
  std::vector<nlohmann::ordered_json> said;
  {
    LiveObserver observer(
        robot().parts(), "a drive",
        [&](const DriveEvidence& evidence) {
          const std::lock_guard lock(mutex);
          said.push_back(to_json(evidence));
        },
        most_queued);
    for (const simulation::Arrival& arrival : robot().arrivals) observer.take(arrival.record);
    REQUIRE(observer.drain(120));
  }
  return said;
}

/// The same without a thread, all at the end.
DriveEvidence learned_at_once() {
  ScanPairing pairing(robot().parts().lasers);
  DriveObserver observer(robot().parts());
  for (const simulation::Arrival& arrival : robot().arrivals) {
    pairing.take(arrival.record);
    while (const auto sample = pairing.next()) observer.update(*sample);
  }
  return observer.finish("a drive");
}

}  // namespace

TEST_CASE("what is learned while a robot drives is what its recording teaches, visit by visit") {
  const DriveEvidence whole = learned_at_once();
  REQUIRE_FALSE(whole.visits.empty());
  nlohmann::ordered_json visits = nlohmann::ordered_json::array();
  int told = 0;
  for (const nlohmann::ordered_json& live : learned_live(100'000)) {
    CHECK(live["drive"] == "a drive, part " + std::to_string(++told));
    for (const nlohmann::ordered_json& visit : live["visits"]) visits.push_back(visit);
  }
  CHECK(visits == to_json(whole)["visits"]);
}

TEST_CASE("an observer that cannot keep up drops the oldest records and goes on") {
  CHECK(learned_live(10).size() <= learned_at_once().visits.size());
}

TEST_CASE("what goes wrong with what was learned ends neither the robot nor what comes later") {
  std::mutex mutex;
  int told = 0;
  {
    LiveObserver observer(
        robot().parts(), "a drive",
        [&](const DriveEvidence&) {
          const std::lock_guard lock(mutex);
          ++told;
          throw std::runtime_error("the disk is gone");
        },
        100'000);
    for (const simulation::Arrival& arrival : robot().arrivals) observer.take(arrival.record);
    REQUIRE(observer.drain(120));
  }
  CHECK(told > 0);
}
