#include "plugins/mcap_log/mcap_log.hpp"
#include "bag_writer.hpp"
#include "recording/containers/mcap_writer.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>

#include <catch2/catch.hpp>

#include <sstream>

namespace {

using namespace opal;
using namespace opal::log_tests;

const std::vector<double> kStandingStill{0, 0, 0, 0, 0, 0, 1};

std::int64_t nanoseconds_of(double stamp_s) { return static_cast<std::int64_t>(stamp_s * 1e9); }

/// Scans and odometry at whole seconds, and where the laser is mounted.
std::string mcap_drive(int from_s, int to_s) {
  std::ostringstream out;
  recording::McapWriter writer(out, "drive.mcap");
  const auto channel = [&writer](const std::string& topic, const std::string& type) {
    return writer.add_channel(topic, writer.add_schema(type, "ros2msg", ""), "cdr");
  };
  const auto scans = channel("/scan", "sensor_msgs/msg/LaserScan");
  const auto odometry = channel("/odom", "nav_msgs/msg/Odometry");
  const auto frames = channel("/tf_static", "tf2_msgs/msg/TFMessage");
  const auto write = [&writer](std::uint16_t to, double stamp_s, const std::string& bytes) {
    writer.write(to, 0, nanoseconds_of(stamp_s), nanoseconds_of(stamp_s), std::as_bytes(std::span(bytes)));
  };
  write(frames, from_s, transforms_bytes({{"base_link", "laser", {0.3, 0, 0, 0, 0, 0, 1}}}));
  for (int second = from_s; second < to_s; ++second) {
    LaserScanMessage scan;
    scan.stamp_s = second;
    write(scans, second, scan.bytes());
    write(odometry, second, odometry_bytes(second, kStandingStill));
  }
  writer.finish();
  return out.str();
}

}  // namespace

TEST_CASE("scans, odometry and the mount of an MCAP recording become records") {
  const TemporaryFile file("drive.bin", mcap_drive(1, 6));  // the name does not matter
  const mcap_log::McapLog source({});
  CHECK(source.recognizes(file.path()));
  const auto reader = source.open(file.path());
  const std::vector<LogRecord> records = read_all(*reader);
  REQUIRE(records.size() == 11);
  CHECK(std::get<MountRecord>(records[0]).T_parent_child.x() == Approx(0.3));
  CHECK(std::get<RawScan>(records[1]).stamp_s == 1);
  CHECK(std::get<OdometryRecord>(records[10]).stamp_s == 5);
  CHECK(reader->defects().empty());
  CHECK(reader->progress() == 1);
}

TEST_CASE("the files of an MCAP recording are read by time, as one") {
  const TemporaryFolder folder;
  folder.write("part_0.mcap", mcap_drive(10, 12));
  folder.write("part_1.mcap", mcap_drive(1, 4));
  folder.write("metadata.yaml", "ignored");
  const mcap_log::McapLog source({});
  CHECK(source.recognizes(folder.path()));
  const LogContents contents = source.contents(folder.path());
  CHECK(contents.first_s == 1);
  CHECK(contents.last_s == 11);
  REQUIRE(contents.lasers.size() == 1);
  CHECK(contents.lasers[0].scans == 5);
  const auto reader = source.open(folder.path());
  std::vector<double> stamps_s;
  while (const auto record = reader->next())
    if (const auto* scan = std::get_if<RawScan>(&*record)) stamps_s.push_back(scan->stamp_s);
  CHECK(stamps_s == std::vector<double>{1, 2, 3, 10, 11});
}

TEST_CASE("an MCAP recording without a laser can be looked at, but not played") {
  std::ostringstream out;
  recording::McapWriter writer(out, "drive.mcap");
  writer.add_channel("/chatter", writer.add_schema("std_msgs/msg/String", "ros2msg", ""), "cdr");
  writer.finish();
  const TemporaryFile file("drive.mcap", out.str());
  const mcap_log::McapLog source({});
  const std::string complaint = file.path() + ": no topic of type sensor_msgs/LaserScan that can be read";
  CHECK_THROWS_WITH(source.open(file.path()), complaint);
  const LogContents contents = source.contents(file.path());
  REQUIRE(contents.topics.size() == 1);
  CHECK(contents.topics[0].name == "/chatter");
  CHECK(contents.lasers.empty());
  CHECK(contents.defects.count(complaint) == 1);
}
