#include "sensing/log_tally.hpp"

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
