// Recorded bags are not part of this repository: where they are absent, these tests say so and pass.
#include "plugins/ros1_bag/ros1_bag.hpp"

#include <opal/sensing/replay.hpp>

#include <catch2/catch.hpp>

#include <filesystem>

namespace {

using namespace opal;

const std::string kBags = OPAL_SOURCE_DIR "/../shared/data/ros1/";

bool is_there(const std::string& bag) {
  const bool exists = std::filesystem::exists(kBags + bag);
  if (!exists) WARN("skipped: no recording " + kBags + bag);
  return exists;
}

/// Scans and poses that `open` gives.
std::pair<int, int> scans_and_poses(const std::string& bag, const recording::TopicChoice& topics = {}) {
  const auto reader = ros1_bag::Ros1Bag(topics).open(kBags + bag);
  int scans = 0, poses = 0;
  while (const auto record = reader->next()) {
    scans += std::holds_alternative<RawScan>(*record) ? 1 : 0;
    poses += std::holds_alternative<OdometryRecord>(*record) ? 1 : 0;
  }
  return {scans, poses};
}

}  // namespace

TEST_CASE("a genuine bag with two lasers gives the one that is asked for, and tells the mounts of both") {
  const std::string bag = "guardian_3.bag";
  if (!is_there(bag)) return;
  recording::TopicChoice rear;
  rear.scans = {"/hokuyo_back_scan"};
  CHECK(scans_and_poses(bag) == std::pair(1036, 2079));
  CHECK(scans_and_poses(bag, rear) == std::pair(1038, 2079));
  const LogContents contents = ros1_bag::Ros1Bag({}).contents(kBags + bag);
  REQUIRE(contents.lasers.size() == 2);
  REQUIRE((contents.lasers[0].mount && contents.lasers[1].mount));
  CHECK(contents.lasers[0].mount->T_base_laser.x() == Approx(-0.432).margin(1e-3));
  CHECK(contents.lasers[1].mount->T_base_laser.x() == Approx(0.486).margin(1e-3));
  CHECK(contents.lasers[1].is_read);
  CHECK(contents.lasers[1].sweep_s == Approx(0.066).margin(1e-3));
}

TEST_CASE("a genuine damaged bag gives what is whole, and tells what is not") {
  const std::string bag = "ist_1_damaged.bag";
  if (!is_there(bag)) return;
  CHECK(scans_and_poses(bag) == std::pair(167, 157));
  const LogContents contents = ros1_bag::Ros1Bag({}).contents(kBags + bag);
  CHECK(contents.defects ==
        std::map<std::string, int>{
            {"no whole record at byte 814907: 49 bytes are left out, expected a record of a bag", 1}});
}
