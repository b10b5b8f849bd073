#include "fleet/fleet_evidence.hpp"

#include "store_in_memory.hpp"
#include "tests/kit/temporary_folder.hpp"
#include "tests/learning/made_drives.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace opal;
using namespace opal::made;
using Catch::Contains;

namespace {

const StoreSource kVersion{"hall", 1};

std::vector<DriveEvidence> ten_drives() {
  std::vector<DriveEvidence> drives;
  for (int k = 0; k < 10; ++k)
    drives.push_back(drive("robot-" + std::to_string(k),
                           {seen("wall-1", kMoved, {0.2 + 0.01 * k, 0}), seen("wall-2", k % 3 ? kThere : kGone)}));
  return drives;
}

void keep(const EvidenceOutbox& outbox, const StoreInMemory& store, const DriveEvidence& drive,
          const StoreSource& version = kVersion) {
  outbox.keep(store.where(), version, to_json(drive).dump());
}

std::string overlay_text(const std::vector<DriveEvidence>& drives) {
  return overlay_of(*room(), learned_from(*room(), drives), kSensor, kLeastProbability).dump(1);
}

}  // namespace

TEST_CASE("ten robots through one store teach the same as one robot in ten drives, whatever the order") {
  const std::string alone = overlay_text(ten_drives());
  CHECK_THAT(alone, Contains("wall-1"));
  for (const int first : {0, 3, 7}) {
    std::vector<DriveEvidence> drives = ten_drives();
    std::rotate(drives.begin(), drives.begin() + first, drives.end());
    const StoreInMemory store;
    for (const DriveEvidence& drive : drives) {
      const TemporaryFolder robot;
      const EvidenceOutbox outbox(robot.path());
      keep(outbox, store, drive);
      CHECK(send_waiting(store, outbox).added == 1);
    }
    const FleetEvidence fleet = evidence_in(store, kVersion, "room");
    CHECK(fleet.refused.empty());
    CHECK(overlay_text(fleet.drives) == alone);
  }
}

TEST_CASE("nothing is lost when the store is away, and nothing counts twice when it breaks in the commit") {
  const TemporaryFolder robot;
  const EvidenceOutbox outbox(robot.path());
  StoreInMemory store;
  const auto drives = ten_drives();
  keep(outbox, store, drives[0]);
  store.is_away = true;
  CHECK_THROWS_AS(send_waiting(store, outbox), StoreUnreachable);
  CHECK(outbox.waiting_for(store.where()).size() == 1);
  keep(outbox, store, drives[1]);
  store.is_away = false;
  store.breaks_after_commit = true;
  CHECK_THROWS_AS(send_waiting(store, outbox), StoreUnreachable);
  CHECK(outbox.waiting_for(store.where()).size() == 2);
  store.breaks_after_commit = false;
  const SentEvidence sent = send_waiting(store, outbox);
  CHECK(sent.confirmed == 2);
  CHECK(sent.added == 0);
  CHECK(outbox.waiting_for(store.where()).empty());
  CHECK(evidence_in(store, kVersion, "room").drives.size() == 2);
}

TEST_CASE("drives on a version that the store does not take wait on, and the others arrive") {
  const TemporaryFolder robot;
  const EvidenceOutbox outbox(robot.path());
  StoreInMemory store;
  store.unknown = "attic";
  const auto drives = ten_drives();
  keep(outbox, store, drives[0], {"attic", 1});
  keep(outbox, store, drives[1]);
  const SentEvidence sent = send_waiting(store, outbox);
  CHECK(sent.confirmed == 1);
  REQUIRE(sent.refused.size() == 1);
  CHECK_THAT(sent.refused[0], Contains("attic"));
  CHECK(outbox.waiting_for(store.where()).size() == 1);
}

TEST_CASE("what a robot adds by mistake is named, and keeps nobody from the rest") {
  const StoreInMemory store;
  auto elsewhere = drive("lost", {seen("wall-1", kMoved, {1, 0})});
  elsewhere.map = "another room";
  auto huge = to_json(ten_drives()[0]);
  huge["learned_m"] = 1e300;
  store.add_evidence(
      "hall", 1, {to_json(ten_drives()[3]).dump(), "[1, 2]", "no json", "{}", to_json(elsewhere).dump(), huge.dump()});
  const FleetEvidence fleet = evidence_in(store, kVersion, "room");
  REQUIRE(fleet.drives.size() == 1);
  CHECK(fleet.drives[0].drive == "robot-3");
  CHECK(fleet.refused.size() == 5);
  for (const std::string& refusal : fleet.refused)
    CHECK_THAT(refusal, Contains("evidence of robot-7 from 2026-11-21T14:02:11Z"));
}
