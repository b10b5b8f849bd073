#include "robot_messages.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace robot_messages;

const Topic kRear{"/rear", "sensor_msgs/msg/LaserScan", Wire::cdr};

TopicChoice two_lasers() {
  TopicChoice topics;
  topics.scans = {"/scan", "/rear"};
  return topics;
}

std::string rear_scan_of(double stamp_s) {
  log_tests::LaserScanMessage scan;
  scan.stamp_s = stamp_s;
  scan.frame = "rear";
  return scan.bytes();
}

/// Frames of the scans that were streamed.
std::vector<std::string> frames_of(const std::vector<LogRecord>& records) {
  std::vector<std::string> frames;
  for (const LogRecord& record : records)
    if (const auto* scan = std::get_if<RawScan>(&record)) frames.push_back(scan->frame);
  return frames;
}

/// A robot whose rear laser says nothing.
std::vector<ReceivedMessage> front_alone(double from_s, double to_s) {
  std::vector<ReceivedMessage> messages{received(kStatic, from_s, laser_link(0.3))};
  for (double s = from_s; s <= to_s; s += 0.5) {
    messages.push_back(received(kScan, s, scan_of(s)));
    messages.push_back(received(kTf, s, odometry_link(s, 0)));
  }
  return messages;
}

}  // namespace

TEST_CASE("a laser that never sends is waited for three seconds, then the other one goes on alone") {
  RosStream stream(two_lasers());
  CHECK(streamed(stream, front_alone(1, 3.5)).empty());
  CHECK(stream.waits_for() == "scans on /rear");
  CHECK(frames_of(streamed(stream, front_alone(4, 5))).size() == 6 + 3);  // none was lost
  CHECK(stream.absent_lasers() == std::vector<std::string>{"/rear"});
  CHECK(stream.mounts().size() == 1);
}

TEST_CASE("a laser that appears late is used as soon as its mount is known") {
  RosStream stream(two_lasers());
  streamed(stream, front_alone(1, 5));
  CHECK(frames_of(streamed(stream, {received(kRear, 6, rear_scan_of(6))})).empty());
  CHECK(stream.absent_lasers() == std::vector<std::string>{"/rear"});
  const std::string rear_link = log_tests::transforms_bytes({{"base", "rear", {-0.4, 0, 0, 1, 0, 0, 0}}});
  const auto records = streamed(stream, {received(kStatic, 6.1, rear_link), received(kRear, 6.2, rear_scan_of(6.2)),
                                         received(kScan, 6.3, scan_of(6.3))});
  CHECK(frames_of(records) == std::vector<std::string>{"rear", "laser"});
  CHECK(stream.absent_lasers().empty());
  REQUIRE(stream.mounts().size() == 2);
  CHECK(stream.mounts()[1].T_parent_child.x() == Approx(-0.4));
  CHECK(*std::get<RawScan>(records[0]).angle_increment_rad < 0);  // upside down
}

TEST_CASE("a laser that appears late without a mount is used after the patience for mounts") {
  RosStream stream(two_lasers(), 2);
  streamed(stream, front_alone(1, 5));
  CHECK(frames_of(streamed(stream, {received(kRear, 6, rear_scan_of(6)), received(kRear, 7.9, rear_scan_of(7.9)),
                                    received(kRear, 8.1, rear_scan_of(8.1))})) == std::vector<std::string>{"rear"});
  CHECK(stream.defects().count("no static transform from base to rear") == 1);
}
