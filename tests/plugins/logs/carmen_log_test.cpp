#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>
#include "plugins/carmen_log/carmen_log.hpp"

#include <zlib.h>
#include <catch2/catch.hpp>

#include <cmath>

namespace {

using namespace opal;
using carmen_log::CarmenLog;

const std::string kStart =
    "# a comment\n"
    "PARAM robot_length 0.5 nohost 0\n"
    "ODOM 1.5 -2 0.25 0 0 0 10.5 nohost 10.5\n";
const std::string kScan = "FLASER 4 1.25 81.91 0 nan 1 2 0.5 1.1 2.2 0.6 11 nohost 11\n";

using Counts = std::map<std::string, int>;

struct Walked {
  std::vector<LogRecord> records;
  Counts defects;

  std::vector<RawScan> scans() const {
    std::vector<RawScan> scans;
    for (const LogRecord& record : records)
      if (const auto* scan = std::get_if<RawScan>(&record)) scans.push_back(*scan);
    return scans;
  }
};

Walked walk_file(const std::string& path, const std::string& laser_message = "") {
  const auto reader = CarmenLog(laser_message).open(path);
  Walked walked{read_all(*reader), {}};
  walked.defects = reader->defects();
  CHECK(reader->progress() == 1);
  return walked;
}

Walked walk(const std::string& text, const std::string& laser_message = "") {
  const TemporaryFolder folder;
  return walk_file(folder.write("a.log", text), laser_message);
}

std::string gzipped(const TemporaryFolder& folder, const std::string& text) {
  const std::string path = folder.path_of("a.log.gz");
  const gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  return path;
}

std::string long_log(int scans) {
  std::string text;
  for (int i = 0; i < scans; ++i) {
    text += "FLASER 360";
    for (int beam = 0; beam < 360; ++beam) text += " " + std::to_string(1 + (i * 7919 + beam * 104729) % 30000) + ".5";
    text += " 0 0 0 0 0 0 " + std::to_string(i) + " nohost 0\n";
  }
  return text;
}

}  // namespace

TEST_CASE("ODOM and FLASER become records, in file order") {
  const Walked walked = walk(kStart + kScan);
  REQUIRE(walked.records.size() == 2);
  const auto& odometry = std::get<OdometryRecord>(walked.records[0]);
  CHECK(odometry.stamp_s == 10.5);
  CHECK(odometry.T_odom_base.x() == 1.5);
  CHECK(odometry.T_odom_base.y() == -2);
  CHECK(odometry.T_odom_base.heading_rad() == 0.25);
  const auto& scan = std::get<RawScan>(walked.records[1]);
  CHECK(scan.stamp_s == 11);
  REQUIRE(scan.ranges_m.size() == 4);
  CHECK(scan.ranges_m[0] == 1.25f);
  CHECK(scan.ranges_m[1] == 81.91f);
  CHECK(std::isnan(scan.ranges_m[3]));
  REQUIRE(scan.T_odom_base);
  CHECK(scan.T_odom_base->x() == 1.1);  // the robot's pose, not the laser's
  CHECK(scan.T_odom_base->heading_rad() == Approx(0.6));
  CHECK_FALSE(scan.angle_min_rad);
  CHECK(walked.defects == Counts{});
}

TEST_CASE("a damaged line is skipped, counted by its cause, and the next one is read") {
  struct Damage {
    std::string line;
    std::string cause;
  };
  const auto damage = GENERATE(values<Damage>({
      {"ODOM 1 2\n", "malformed line"},
      {"ODOM one 2 3 0 0 0 4 nohost 4\n", "malformed line"},
      {"FLASER\n", "malformed line"},
      {"FLASER 3 1 1 1\n", "malformed line"},
      {"FLASER -1 1 1 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},
      {"FLASER 4000000000 1 1 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},
      {"FLASER 2000000000 1 1 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},
      {"FLASER 1e2 1 1 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},
      {"FLASER 2 1 1 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},  // one more than announced
      {"FLASER 4 1 1 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},  // one less
      {"FLASER 3 1 x 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},
      {"FLASER 3 1 1.2.3 1 0 0 0 0 0 0 11 nohost 11\n", "malformed line"},
      {"FLASER 1 1 0 0 0 0 0 0 nan nohost 11\n", "stamp that is no time"},
      {"FLASER 1 1 0 0 0 0 0 0 inf nohost 11\n", "stamp that is no time"},
      {"ODOM 1 2 3 0 0 0 1e300 nohost 4\n", "stamp that is no time"},
      {"ODOM nan 2 3 0 0 0 4 nohost 4\n", "odometry that is no pose"},
      {"ODOM 1e200 2 3 0 0 0 4 nohost 4\n", "odometry that is no pose"},
      {"LASER_CAT 1 2 3\n", ""},
      {std::string("\0\1\2\xff garbage\n", 13), "malformed line"},
  }));
  INFO(damage.line);
  const Walked walked = walk(kStart + damage.line + kScan);
  CHECK(walked.records.size() == 2);
  CHECK(walked.defects == (damage.cause.empty() ? Counts{} : Counts{{damage.cause, 1}}));
}

TEST_CASE("a scan whose odometry is no pose is kept without it") {
  const Walked walked = walk(kStart + "FLASER 1 5 0 0 0 nan 0 0 11 nohost 11\n");
  REQUIRE(walked.scans().size() == 1);
  CHECK_FALSE(walked.scans()[0].T_odom_base);
  CHECK(walked.defects == Counts{{"odometry that is no pose", 1}});
}

TEST_CASE("wherever the last line is cut, no wrong record comes out of it") {
  const std::string last = "ODOM 1.5 -2.25 0.25 0 0 0 12.75 nohost 12.75\n";
  for (std::size_t length = 1; length < last.size(); ++length) {
    const std::string cut = last.substr(0, length);
    INFO(cut);
    const Walked walked = walk(kStart + cut);
    const bool whole = length >= last.find("nohost");  // then the stamp's end is certain
    REQUIRE(walked.records.size() == (whole ? 2 : 1));
    CHECK(walked.defects == (whole ? Counts{} : Counts{{"truncated last line", 1}}));
    if (whole) CHECK(std::get<OdometryRecord>(walked.records[1]).stamp_s == 12.75);
  }
  for (std::size_t length = 1; length < kScan.find("nohost"); ++length) {
    const Walked walked = walk(kStart + kScan.substr(0, length));
    INFO(kScan.substr(0, length));
    CHECK(walked.scans().empty());
    CHECK(walked.defects == Counts{{"truncated last line", 1}});
  }
}

TEST_CASE("carriage returns, tabs, plus signs and repeated blanks are no damage") {
  const Walked walked = walk("ODOM  +1.5\t-2 0.25 0 0 0 10.5 nohost 10.5 \r\n\r\n\n" + kScan);
  CHECK(walked.records.size() == 2);
  CHECK(walked.defects == Counts{});
}

TEST_CASE("newer messages state their own beams") {
  const std::string robot_laser =
      "ROBOTLASER1 0 -1.5 3.0 0.5 81.9 0.01 0 3 1.5 2.5 3.5 2 7 8 0.1 0.2 0.3 1.1 2.2 0.6 0 0 0.5 0.4 1e6 11 nohost "
      "11\n";
  const std::string raw_laser = "RAWLASER1 0 -1.5 3.0 0.5 81.9 0.01 0 3 1.5 2.5 3.5 0 12 nohost 12\n";
  const Walked walked = walk(kStart + robot_laser + raw_laser);
  REQUIRE(walked.scans().size() == 1);  // the raw readings are those of the robot's laser once more
  const RawScan scan = walked.scans()[0];
  CHECK(scan.ranges_m == std::vector<float>{1.5f, 2.5f, 3.5f});
  CHECK(scan.angle_min_rad == -1.5);
  CHECK(scan.angle_increment_rad == 0.5);
  CHECK(scan.T_odom_base->x() == 1.1);
  CHECK(scan.stamp_s == 11);
  const Walked raw = walk(kStart + robot_laser + raw_laser, "RAWLASER1");
  REQUIRE(raw.scans().size() == 1);
  CHECK(raw.scans()[0].stamp_s == 12);
  CHECK_FALSE(raw.scans()[0].T_odom_base);
  CHECK(walk(kStart + raw_laser).scans().size() == 1);
  CHECK_THROWS_AS(CarmenLog("SONAR"), ConfigError);
}

TEST_CASE("a log without scans of the laser that is read names the option and the other lasers") {
  const std::string other = "ROBOTLASER0 0 -1 2 1 80 0.01 0 2 1 2 0 1 2 0 1 2 0 0 0 0 0 0 11 nohost 11\n";
  const std::string words = "no scan of FLASER; the option laser_message can name one of ROBOTLASER0";
  CHECK(walk(kStart + other + other).defects == Counts{{words, 1}});
  CHECK(walk(kStart + other + kScan).defects.empty());
  CHECK(walk(kStart).defects.empty());
}

TEST_CASE("compressed logs are read as plain ones are, across blocks") {
  const TemporaryFolder folder;
  const std::string text = long_log(300);
  REQUIRE(text.size() > 600'000);
  const Walked plain = walk_file(folder.write("a.log", text));
  const Walked packed = walk_file(gzipped(folder, text));
  REQUIRE(plain.scans().size() == 300);
  REQUIRE(packed.scans().size() == 300);
  for (std::size_t i = 0; i < 300; ++i) CHECK(plain.scans()[i].ranges_m == packed.scans()[i].ranges_m);
  CHECK(packed.defects == Counts{});
}

TEST_CASE("a compressed file that was cut off is read as far as it goes") {
  const TemporaryFolder folder;
  const std::string path = gzipped(folder, long_log(300));
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const Walked walked = walk_file(path);
  CHECK(walked.scans().size() == Approx(150).margin(20));
  CHECK(walked.defects == Counts{{"truncated file", 1}, {"truncated last line", 1}});
}

TEST_CASE("compression that was damaged ends the log, and is counted") {
  const TemporaryFolder folder;
  const std::string path = gzipped(folder, long_log(300));
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(path) / 2));
    file << std::string(64, '\xff');
  }
  const Walked walked = walk_file(path);
  CHECK(walked.scans().size() < 300);
  CHECK(walked.defects.count("damaged compression") == 1);
}

TEST_CASE("a line without an end is passed over, whatever its length") {
  const Walked walked = walk(kStart + "FLASER " + std::string(9'000'000, '1') + "\n" + kScan);
  CHECK(walked.records.size() == 2);
  CHECK(walked.defects == Counts{{"line of more than 4 MB", 1}});
}

TEST_CASE("only CARMEN logs are recognized, others are refused by name") {
  const TemporaryFolder folder;
  const CarmenLog source("");
  CHECK(source.recognizes(folder.write("good.txt", kStart)));
  CHECK(source.recognizes(gzipped(folder, kStart)));
  for (const std::string content : {"", "\n\n", "# only a comment\n", "{\"laser\": 1}", "FLASERS 1\n"}) {
    const std::string path = folder.write("bad.log", content);
    INFO(content);
    CHECK_FALSE(source.recognizes(path));
    CHECK_THROWS_WITH(source.open(path), Catch::StartsWith(path + ": no line"));
  }
  for (const std::string& path : {folder.path(), folder.path_of("missing.log")}) {
    CHECK_FALSE(source.recognizes(path));
    CHECK_THROWS_AS(source.open(path), LogError);
  }
}
