#include "sensing/log_check.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <tuple>

using namespace opal;

namespace {

LaserModel described(int beams) {
  LaserModel laser;
  laser.beams = beams;
  return laser;
}

std::vector<LogRecord> log_with(std::size_t beams, int scans = 3) {
  RawScan raw;
  raw.ranges_m.assign(beams, 2.0f);
  return std::vector<LogRecord>(static_cast<std::size_t>(scans), raw);
}

std::string complaint(const std::vector<LogRecord>& records, const LaserModel& laser) {
  return refused_with<ConfigError>([&] { check_log(records, laser, "a.log", "b.jsonld: /sensor"); });
}

}  // namespace

TEST_CASE("a log with another number of beams than described is refused with both numbers") {
  const std::string said = complaint(log_with(541), described(361));
  CHECK_THAT(said, Catch::StartsWith("b.jsonld: /sensor: "));
  CHECK_THAT(said, Catch::Contains("361 beams") && Catch::Contains("a.log have 541"));
  CHECK(complaint(log_with(361), described(361)) == "accepted");
}

TEST_CASE("a few cut scans do not speak against the description, and an empty log says nothing") {
  auto records = log_with(361, 5);
  for (const LogRecord& cut : log_with(17, 2)) records.push_back(cut);
  CHECK(complaint(records, described(361)) == "accepted");
  CHECK(complaint({}, described(361)) == "accepted");
}

TEST_CASE("angles that the log states must be those described, unless they are taken from it") {
  auto records = log_with(361);
  for (LogRecord& record : records) {
    auto& raw = std::get<RawScan>(record);
    raw.angle_min_rad = -std::numbers::pi / 2;
    raw.angle_increment_rad = std::numbers::pi / 360;
  }
  LaserModel laser = described(361);
  CHECK(complaint(records, laser) == "accepted");
  laser.angle_min_rad += 0.02;
  CHECK_THAT(complaint(records, laser), Catch::Contains("-88.854") && Catch::Contains("-90.000"));
  laser.geometry_from_log = true;
  CHECK(complaint(records, laser) == "accepted");
  laser = described(361);
  laser.angle_increment_rad *= 1.1;
  CHECK_THAT(complaint(records, laser), Catch::Contains("degrees apart"));
}

TEST_CASE("a description beside the log is named, if there is one") {
  CHECK_THAT(complaint(log_with(541), described(361)), !Catch::Contains("--info"));
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "opal_log_check_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.info.json") << "{}";
  CHECK_THROWS_WITH(check_log(log_with(541), described(361), (folder / "a.log").string(), "b.jsonld: /sensor"),
                    Catch::Contains("or take it with --info") && Catch::Contains("a.info.json"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("half a beam at either end may be off: over all beams, one of them") {
  const auto complaint_at = [](double increment_rad) {
    auto records = log_with(3);
    for (LogRecord& record : records) {
      std::get<RawScan>(record).angle_min_rad = -0.1;
      std::get<RawScan>(record).angle_increment_rad = increment_rad;
    }
    LaserModel laser = described(3);
    laser.angle_min_rad = -0.1;
    laser.angle_increment_rad = 0.1;
    return complaint(records, laser);
  };
  CHECK(complaint_at(0.145) == "accepted");
  CHECK(complaint_at(0.155) != "accepted");
}

TEST_CASE("a laser whose frame no scan has is refused with both names, alone, too") {
  auto records = log_with(361);
  for (LogRecord& record : records) std::get<RawScan>(record).frame = "base_scan";
  LaserModel laser = described(361);
  CHECK_NOTHROW(lasers_of_log(records, {laser}, "a.log", "b.jsonld: /sensor"));
  laser.frame = "laser";
  CHECK_THROWS_WITH(lasers_of_log(records, {laser}, "a.log", "b.jsonld: /sensor"),
                    "b.jsonld: /sensor: a.log has no scan of frame \"laser\"; its scans have: \"base_scan\"");
}

TEST_CASE("a laser that never speaks stays as described, or is left out if its scans tell its geometry") {
  auto records = log_with(361);
  for (LogRecord& record : records) std::get<RawScan>(record).frame = "front";
  LaserModel front = described(361), rear = described(181);
  front.frame = "front";
  rear.frame = "rear";
  CHECK(lasers_of_log(records, {front, rear}, "the robot", "b.jsonld: /sensor").size() == 2);
  CHECK(silent_lasers(records, std::vector{front, rear}) == std::vector<std::string>{"rear"});
  rear.geometry_from_log = true;
  const auto alone = lasers_of_log(records, {front, rear}, "the robot", "b.jsonld: /sensor");
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].frame == "front");
  std::get<RawScan>(records.back()).frame = "rear";
  CHECK_THROWS_AS(lasers_of_log(records, {front, described(5)}, "the robot", "b.jsonld: /sensor"), ConfigError);
}

TEST_CASE("scans of a frame that nobody describes are told, where a described laser has none") {
  auto records = log_with(361);
  for (LogRecord& record : records) std::get<RawScan>(record).frame = "front";
  std::get<RawScan>(records.back()).frame = "behind";
  LaserModel front = described(361), rear = described(361);
  front.frame = "front";
  rear.frame = "rear";
  CHECK_THROWS_WITH(
      lasers_of_log(records, {front, rear}, "the robot", "b.jsonld: /sensor"),
      "b.jsonld: /sensor/1: the robot has no scan of frame \"rear\"; its scans have: \"behind\", \"front\"");
}

TEST_CASE("lasers come back with the beams that their own scans state, each with those of its frame") {
  std::vector<LogRecord> records;
  for (const auto& [frame, beams, min_rad] : {std::tuple{"front", 361u, -1.0}, std::tuple{"rear", 181u, -0.5}}) {
    RawScan raw;
    raw.frame = frame;
    raw.ranges_m.assign(beams, 2.0f);
    raw.angle_min_rad = min_rad;
    raw.angle_increment_rad = 0.005;
    records.insert(records.end(), 3, raw);
  }
  LaserModel front = described(7), rear = described(7);
  front.frame = "front";
  rear.frame = "rear";
  front.geometry_from_log = rear.geometry_from_log = true;
  const auto lasers = lasers_of_log(records, {front, rear}, "the robot", "b.jsonld: /sensor");
  REQUIRE(lasers.size() == 2);
  CHECK((lasers[0].beams == 361 && lasers[0].angle_min_rad == -1.0));
  CHECK((lasers[1].beams == 181 && lasers[1].angle_min_rad == -0.5));
  front.geometry_from_log = rear.geometry_from_log = false;
  front.beams = 361;
  front.angle_min_rad = -1.0;
  front.angle_increment_rad = 0.005;
  CHECK_THROWS_WITH(lasers_of_log(records, {front, rear}, "the robot", "b.jsonld: /sensor"),
                    Catch::StartsWith("b.jsonld: /sensor/1: ") && Catch::Contains("the robot have 181"));
}

TEST_CASE("a laser that is to take its beams from a log which states none is held against the description") {
  LaserModel laser = described(361);
  laser.geometry_from_log = true;
  CHECK_THAT(complaint(log_with(541), laser), Catch::Contains("361 beams") && Catch::Contains("a.log have 541"));
  CHECK(complaint(log_with(361), laser) == "accepted");
}
