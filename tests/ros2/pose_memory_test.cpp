#include "ros2/pose_memory.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using opal::Pose2;
using opal::ros2::PoseMemory;

TEST_CASE("the last pose is recalled in the same map, and in no other one") {
  const TemporaryFolder folder;
  const std::string file = folder.path_of("pose.json");
  PoseMemory memory(file, "hall");
  CHECK_FALSE(memory.recall());
  memory.keep(Pose2(1, 2, 3), 10);
  memory.keep(Pose2(4, 5, 6), 10.5);  // too soon
  const auto kept = PoseMemory(file, "hall").recall();
  REQUIRE(kept);
  CHECK(kept->x() == Approx(1));
  CHECK(kept->heading_rad() == Approx(3));
  CHECK_FALSE(PoseMemory(file, "office").recall());
}

TEST_CASE("a damaged file is no pose, and without a file nothing is kept") {
  const TemporaryFolder folder;
  const std::string file = folder.path_of("pose.json");
  for (const char* text : {"", "{", "[]", "{\"map\": \"hall\"}", "{\"map\":\"hall\",\"x_m\":\"a\"}"}) {
    std::ofstream(file) << text;
    CHECK_FALSE(PoseMemory(file, "hall").recall());
  }
  PoseMemory nowhere("", "hall");
  nowhere.keep(Pose2(), 100);
  CHECK_FALSE(nowhere.recall());
}

TEST_CASE("where a pose cannot be kept localization goes on") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path_of("state"));
  PoseMemory memory(folder.path_of("state/pose.json"), "hall");
  std::filesystem::remove(folder.path_of("state"));
  CHECK_NOTHROW(memory.keep(Pose2(1, 2, 3), 10));
  CHECK_FALSE(memory.recall());
}

TEST_CASE("a file of poses that cannot be written is told at the start, and asking leaves nothing") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(PoseMemory(folder.path_of("nope/pose.json"), "hall"), opal::Error);
  const PoseMemory memory(folder.path_of("pose.json"), "hall");
  CHECK(std::filesystem::is_empty(folder.path_of(".")));
}
