#include "sensing/log_tally.hpp"

#include <opal/sensing/log_source.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace opal;

TEST_CASE("rate and longest pause of a topic come from the times of its messages, in any order") {
  StampTally tally;
  for (const double stamp_s : {10.0, 10.1, 12.5, 10.2, 10.3, 12.6}) tally.add(stamp_s);
  LogTopic topic;
  tally.tell(topic);
  CHECK(topic.messages == 6);
  CHECK(topic.first_s == 10);
  CHECK(topic.last_s == 12.6);
  CHECK(topic.interval_s == Approx(0.1));
  CHECK(topic.gaps == 1);
  CHECK(topic.longest_gap_s == Approx(2.2));
  CHECK(topic.longest_gap_at_s == Approx(10.3));
}

TEST_CASE("a range that many readings share, and none exceeds, stands for no return") {
  LaserTally tally;
  RawScan scan;
  scan.ranges_m = {0.5f, 1, 2, 3, 5.6f, 5.6f, std::numeric_limits<float>::infinity(), std::nanf(""), 0, 4};
  tally.add(scan);
  LogLaser laser;
  tally.tell(laser);
  CHECK(laser.beams == 10);
  CHECK(laser.nearest_m == 0.5);
  CHECK(laser.farthest_m == 4);
  CHECK(laser.no_return_m == Approx(5.6));
  CHECK(laser.no_return_share == Approx(0.3));
  CHECK(laser.invalid_share == Approx(0.2));
}

TEST_CASE("a range that only one reading has is as far as the laser saw, however many shared the farthest one before") {
  LaserTally tally;
  RawScan scan;
  scan.ranges_m.assign(200, 3.0f);
  scan.ranges_m.push_back(4.0f);
  for (int k = 0; k < 200; ++k) scan.ranges_m.push_back(2.0f);
  tally.add(scan);
  LogLaser laser;
  tally.tell(laser);
  CHECK(laser.no_return_m == 0);
  CHECK(laser.farthest_m == 4);
}

TEST_CASE("most scans say how many beams a laser has") {
  LaserTally tally;
  for (const std::size_t beams : {4u, 6u, 6u}) {
    RawScan scan;
    scan.ranges_m.assign(beams, 1.0f);
    tally.add(scan);
  }
  LogLaser laser;
  tally.tell(laser);
  CHECK(laser.scans == 3);
  CHECK(laser.beams == 6);
  CHECK(laser.other_scans == 1);
}

TEST_CASE("odometry tells how far the robot drove and turned") {
  OdometryTally tally;
  for (const Pose2& pose : {Pose2(0, 0, 0), Pose2(3, 4, 1), Pose2(3, 4, 0)}) tally.add(pose);
  LogOdometry odometry;
  tally.tell(odometry);
  CHECK(odometry.poses == 3);
  CHECK(odometry.driven_m == Approx(5));
  CHECK(odometry.turned_rad == Approx(2));
}

namespace {

struct ListedRecords final : LogReader {
  explicit ListedRecords(std::vector<LogRecord> all) : records(std::move(all)) {}
  std::optional<LogRecord> next() override {
    return position < records.size() ? std::optional(records[position++]) : std::nullopt;
  }
  std::map<std::string, int> defects() const override { return {{"malformed line", 3}}; }
  double progress() const override { return 0; }
  std::vector<LogRecord> records;
  std::size_t position = 0;
};

RawScan scan_of_front(double stamp_s, const Pose2& T_odom_base) {
  RawScan scan;
  scan.stamp_s = stamp_s;
  scan.frame = "front";
  scan.ranges_m.assign(5, 2.0f);
  scan.T_odom_base = T_odom_base;
  return scan;
}

}  // namespace

TEST_CASE("a log tells its laser with its mount, its odometry, and from when to when it lasts") {
  ListedRecords reader({MountRecord{"base_link", "rear", Pose2(-1, 0, 3)},
                        MountRecord{"base_link", "front", Pose2(0.3, 0, 0)}, OdometryRecord{10, Pose2()},
                        scan_of_front(11, Pose2(1, 0, 0)), scan_of_front(12, Pose2(1.5, 0, 0)),
                        OdometryRecord{13, Pose2(4, 3, 0)}});
  const LogContents contents = contents_of(reader);
  REQUIRE(contents.lasers.size() == 1);
  CHECK(contents.lasers[0].frame == "front");
  CHECK(contents.lasers[0].topic == "scans");
  CHECK(contents.lasers[0].beams == 5);
  REQUIRE(contents.lasers[0].mount);
  CHECK(contents.lasers[0].mount->T_base_laser.x() == 0.3);
  REQUIRE(contents.odometries.size() == 1);
  CHECK(contents.odometries[0].driven_m == Approx(5));  // the log's own, not that of its scans
  CHECK(contents.first_s == 10);
  CHECK(contents.last_s == 13);
  CHECK(contents.topics.size() == 2);
  CHECK(contents.defects.at("malformed line") == 3);
}

TEST_CASE(
    "of a log, each topic has its name, its times and its pauses, and the laser has its beams as the log states them") {
  std::vector<LogRecord> records;
  for (int k = 0; k < 8; ++k) {
    RawScan scan = scan_of_front(20 + 0.2 * k + (k > 4 ? 3 : 0), Pose2());  // a pause of 3.2 s after the fifth
    scan.angle_min_rad = -1.5;
    scan.angle_increment_rad = 0.75;
    if (k == 2) scan.ranges_m = {1.0f, 7.5f, 0.0f};
    records.push_back(scan);
  }
  for (int k = 0; k < 3; ++k) records.push_back(OdometryRecord{19.5 + 3 * k, Pose2(0, 0, 0.5 * k)});
  ListedRecords reader(std::move(records));
  const LogContents contents = contents_of(reader);
  REQUIRE(contents.topics.size() == 2);
  const LogTopic &odometry = contents.topics[0], &scans = contents.topics[1];
  CHECK((odometry.name == "odometry" && odometry.type == "odometry" && odometry.messages == 3));
  CHECK((scans.name == "scans" && scans.type == "laser scan" && scans.messages == 8));
  CHECK((scans.first_s == 20 && scans.last_s == Approx(24.4) && scans.interval_s == Approx(0.2)));
  CHECK((scans.gaps == 1 && scans.longest_gap_s == Approx(3.2) && scans.longest_gap_at_s == Approx(20.8)));
  CHECK(odometry.gaps == 0);  // its usual interval is 3 s
  CHECK((contents.first_s == 19.5 && contents.last_s == 25.5 && contents.looked_at_s == 25.5));
  const LogLaser& laser = contents.lasers.at(0);
  CHECK((laser.is_read && laser.scans == 8 && laser.beams == 5 && laser.other_scans == 1));
  CHECK((laser.angle_min_rad == -1.5 && laser.angle_increment_rad == 0.75));
  CHECK((laser.nearest_m == 1 && laser.farthest_m == 2 && laser.no_return_m == 7.5));
  CHECK((laser.invalid_share == Approx(1 / 38.) && laser.no_return_share == Approx(1 / 38.)));
  CHECK((contents.odometries.at(0).is_read && contents.odometries[0].turned_rad == Approx(1)));
}

TEST_CASE("pauses are longer than half a second and than five usual intervals") {
  const auto gaps = [](double interval_s, double pause_s) {
    StampTally tally;
    for (int k = 0; k < 9; ++k) tally.add(interval_s * k);
    tally.add(8 * interval_s + pause_s);
    LogTopic topic;
    tally.tell(topic);
    return topic.gaps;
  };
  CHECK((gaps(0.02, 0.45) == 0 && gaps(0.02, 0.55) == 1));
  CHECK((gaps(0.4, 1.9) == 0 && gaps(0.4, 2.1) == 1));
}

TEST_CASE("of two numbers of beams that as many scans have, the smaller one is the laser's") {
  LaserTally tally;
  for (const std::size_t beams : {6u, 4u, 6u, 4u}) {
    RawScan scan;
    scan.ranges_m.assign(beams, 1.0f);
    tally.add(scan);
  }
  LogLaser laser;
  tally.tell(laser);
  CHECK((laser.beams == 4 && laser.other_scans == 2));
}

TEST_CASE("a log that holds nothing tells of no topic, no laser and no odometry") {
  ListedRecords reader({});
  const LogContents contents = contents_of(reader);
  CHECK((contents.topics.empty() && contents.lasers.empty() && contents.odometries.empty()));
}

TEST_CASE("a log without odometry of its own has that of its scans") {
  ListedRecords reader({scan_of_front(11, Pose2(1, 0, 0)), scan_of_front(12, Pose2(1.5, 0, 0))});
  const LogContents contents = contents_of(reader);
  REQUIRE(contents.odometries.size() == 1);
  CHECK(contents.odometries[0].driven_m == Approx(0.5));
  CHECK(contents.last_s == 12);
}
