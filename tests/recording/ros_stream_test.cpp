#include "recording/ros_stream.hpp"
#include "robot_messages.hpp"

#include "recording/ros_contents.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace opal;
using namespace opal::recording;
using namespace robot_messages;

/// Scans come first, the mount last.
std::vector<ReceivedMessage> late_mount() {
  std::vector<ReceivedMessage> messages;
  for (int i = 0; i < 10; ++i) {
    messages.push_back(received(kScan, 1 + 0.1 * i, scan_of(i == 3 ? 0 : 1 + 0.1 * i)));
    messages.push_back(received(kTf, 1.05 + 0.1 * i, odometry_link(1.02 + 0.1 * i, 0.1 * i)));
  }
  messages.insert(messages.begin() + 14, received(kStatic, 1.71, laser_link(0.3)));
  return messages;
}

TopicChoice one_laser() {
  TopicChoice topics;
  topics.scans = {"/scan"};
  return topics;
}

bool is_same(const LogRecord& one, const LogRecord& other) {
  if (one.index() != other.index()) return false;
  if (const auto* scan = std::get_if<RawScan>(&one)) {
    const auto& twin = std::get<RawScan>(other);
    return scan->stamp_s == twin.stamp_s && scan->ranges_m == twin.ranges_m && scan->frame == twin.frame &&
           scan->angle_increment_rad == twin.angle_increment_rad;
  }
  if (const auto* odometry = std::get_if<OdometryRecord>(&one))
    return odometry->stamp_s == std::get<OdometryRecord>(other).stamp_s &&
           odometry->T_odom_base.x() == std::get<OdometryRecord>(other).T_odom_base.x();
  return true;
}

}  // namespace

TEST_CASE("a stream gives the records that a recording of its messages gives, though the mount comes late") {
  RosStream stream(one_laser());
  const std::vector<LogRecord> live = streamed(stream, late_mount());
  const std::vector<LogRecord> replayed = Recorded(late_mount()).records;
  REQUIRE(stream.mounts().size() == 1);
  CHECK(stream.mounts()[0].T_parent_child.x() == Approx(0.3));
  REQUIRE(live.size() == 20);
  REQUIRE(replayed.size() == live.size() + 1);  // the mount
  CHECK(std::get<MountRecord>(replayed[0]).child == stream.mounts()[0].child);
  for (std::size_t i = 0; i < live.size(); ++i) CHECK(is_same(live[i], replayed[i + 1]));
  CHECK(*std::get<RawScan>(live[0]).angle_increment_rad < 0);
}

TEST_CASE("a stream holds everything until the mount is known, and says what it waits for") {
  RosStream stream(one_laser());
  CHECK(stream.waits_for() == "scans on /scan, the transform from odom to the robot on /tf");
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take(received(kTf, 1, odometry_link(1, 0)));
  CHECK_FALSE(stream.next());
  CHECK(stream.waits_for() == "the transform from base to laser on /tf_static");
  stream.take(received(kStatic, 100, laser_link(0)));
  CHECK(stream.waits_for().empty());
  CHECK(stream.next());
}

TEST_CASE("a mount on /tf counts when it has stood still for five seconds") {
  RosStream stream(one_laser());
  stream.take(received(kScan, 1, scan_of(1)));
  for (int second = 1; second < 6; ++second) {
    stream.take(received(kTf, second, odometry_link(second, second)));
    stream.take(received(kTf, second, laser_link(0.2)));
    CHECK_FALSE(stream.is_open());
  }
  stream.take(received(kTf, 6.1, odometry_link(6.1, 6)));
  REQUIRE(stream.is_open());
  CHECK(stream.mounts().at(0).T_parent_child.x() == Approx(0.2));
}

TEST_CASE("a stream that does not need the mount goes on without it, and says so") {
  RosStream stream(one_laser(), 3);
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take(received(kTf, 3.9, odometry_link(4, 0)));
  CHECK_FALSE(stream.is_open());
  stream.take(received(kScan, 4.1, scan_of(4.1)));
  CHECK(stream.is_open());
  CHECK(stream.mounts().empty());
  CHECK(stream.defects().count("no static transform from base to laser") == 1);
}

TEST_CASE("a topic of odometry can be read instead of transforms") {
  const Topic wheels{"/odom", "nav_msgs/msg/Odometry", Wire::cdr};
  RosStream stream(one_laser(), 0);
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take_odometry_from_topic("/odom");
  CHECK(stream.waits_for() == "odometry on /odom");
  stream.take(received(wheels, 2, log_tests::odometry_bytes(2, {1, 2, 0, 0, 0, 0, 1}, "base")));
  REQUIRE(stream.is_open());
  CHECK(std::holds_alternative<RawScan>(*stream.next()->record));
  CHECK(std::get<OdometryRecord>(*stream.next()->record).T_odom_base.y() == 2);
}

TEST_CASE("odometry that does not name the robot is heard, and somebody else may say which frame it is") {
  const Topic wheels{"/odom", "nav_msgs/msg/Odometry", Wire::cdr};
  const bool is_named = GENERATE(false, true);
  TopicChoice topics = one_laser();
  topics.odometry = "/odom";
  if (is_named) topics.base_frame = "base";
  RosStream stream(topics, 10);
  stream.take(received(wheels, 1, log_tests::odometry_bytes(1, {1, 2, 0, 0, 0, 0, 1}, "")));
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take(received(kStatic, 1, laser_link(0.3)));
  CHECK(stream.is_open() == is_named);
  if (!is_named)
    CHECK(stream.waits_for() == "the transform from the robot (/odom does not name its frame) to laser on /tf_static");
  stream.take(received(kScan, 12, scan_of(12)));  // the deployment states the mount
  CHECK(stream.is_open());
  CHECK(stream.mounts().size() == (is_named ? 1 : 0));
  CHECK(stream.odom_frame() == "odom");
}

TEST_CASE("a stream goes back from a topic of odometry to transforms, before it is open and after") {
  const Topic wheels{"/odom", "nav_msgs/msg/Odometry", Wire::cdr};
  const bool is_open = GENERATE(false, true);
  RosStream stream(one_laser());
  stream.take_odometry_from_topic("/odom");
  if (is_open) stream.take(received(kStatic, 1, laser_link(0.3)));
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take(received(wheels, 2, log_tests::odometry_bytes(2, {1, 2, 0, 0, 0, 0, 1}, "base")));
  REQUIRE(stream.is_open() == is_open);
  while (stream.next()) continue;
  REQUIRE(stream.take_odometry_from_transforms("base"));
  stream.take(received(kStatic, 3, laser_link(0.3)));
  stream.take(received(wheels, 3, log_tests::odometry_bytes(3, {8, 2, 0, 0, 0, 0, 1}, "base")));
  stream.take(received(kTf, 3.1, odometry_link(3.1, 5)));
  std::vector<double> xs_m;
  while (const auto next = stream.next())
    if (next->record && std::holds_alternative<OdometryRecord>(*next->record))
      xs_m.push_back(std::get<OdometryRecord>(*next->record).T_odom_base.x());
  CHECK(xs_m == std::vector<double>{5});
}

TEST_CASE("odometry from before the choice of its topic is held, and dropped where transforms are chosen") {
  const Topic wheels{"/odom", "nav_msgs/msg/Odometry", Wire::cdr};
  const bool is_topic = GENERATE(false, true);
  RosStream stream(one_laser());
  stream.take(received(kStatic, 1, laser_link(0.3)));
  stream.take(received(wheels, 1, log_tests::odometry_bytes(1, {7, 0, 0, 0, 0, 0, 1}, "base")));
  stream.take(received(kScan, 2, scan_of(2)));
  if (is_topic) stream.take_odometry_from_topic("/odom");
  stream.take(received(wheels, 3, log_tests::odometry_bytes(3, {8, 0, 0, 0, 0, 0, 1}, "base")));
  if (!is_topic) stream.take(received(kTf, 4, odometry_link(4, 5)));
  REQUIRE(stream.is_open());
  std::vector<double> xs_m;
  int others = 0;
  while (const auto next = stream.next())
    if (next->record && std::holds_alternative<OdometryRecord>(*next->record))
      xs_m.push_back(std::get<OdometryRecord>(*next->record).T_odom_base.x());
    else
      ++others;
  CHECK(xs_m == (is_topic ? std::vector<double>{7, 8} : std::vector<double>{5}));
  CHECK(others == 2);  // the mount and the scan
}

TEST_CASE("an open stream does not go over to transforms of another frame of the robot") {
  const Topic wheels{"/odom", "nav_msgs/msg/Odometry", Wire::cdr};
  RosStream stream(one_laser(), 0);
  stream.take_odometry_from_topic("/odom");
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take(received(wheels, 2, log_tests::odometry_bytes(2, {1, 2, 0, 0, 0, 0, 1}, "base")));
  REQUIRE(stream.is_open());
  CHECK_FALSE(stream.take_odometry_from_transforms("footprint"));
}

TEST_CASE("where a topic and transforms both have odometry, a robot's transforms can go first") {
  const Topic wheels{"/odom", "nav_msgs/msg/Odometry", Wire::cdr};
  std::vector<ReceivedMessage> messages = late_mount();
  messages.push_back(received(wheels, 2, log_tests::odometry_bytes(2, {1, 2, 0, 0, 0, 0, 1}, "base")));
  const Parts parts = parts_of(messages);
  CHECK(choose_topics("made.mcap", parts, {}).topics.odometry == "/odom");
  CHECK(choose_topics("made.mcap", parts, {}, OdometryFirst::transforms).topics.odometry.empty());
  const auto options = ros_contents("made.mcap", parts, {}, OdometryFirst::transforms).options;
  using Option = std::pair<std::string, std::string>;
  CHECK(options == std::vector<Option>{{"scan_topic", "/scan"}, {"odom_frame", "odom"}, {"base_frame", "base"}});
  TopicChoice elsewhere;
  elsewhere.odom_frame = "odometry";
  CHECK(choose_topics("made.mcap", parts, elsewhere, OdometryFirst::transforms).topics.odometry == "/odom");
}

TEST_CASE("a transform that is no pose does not take those beside it with it, and is counted by its frames") {
  RosStream stream(one_laser());
  const std::string both = log_tests::transforms_bytes(
      {{"base", "camera", {0, 0, 0, 0, 0, 0, 0}}, {"base", "laser", {0.3, 0, 0, 0, 0, 0, 1}}});
  stream.take(received(kStatic, 1, both));
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take(received(kTf, 1, odometry_link(1, 0)));
  REQUIRE(stream.is_open());
  CHECK(stream.mounts().at(0).T_parent_child.x() == Approx(0.3));
  CHECK(stream.defects() == Defects{{"transform from base to camera that is no pose", 1}});
}

TEST_CASE("a mount on /tf counts though it begins late, and not before it has stood still by its own stamps") {
  RosStream stream(one_laser());
  stream.take(received(kScan, 1, scan_of(1)));
  stream.take(received(kTf, 1, odometry_link(1, 0)));
  const auto link = [](double stamp_s) {
    return log_tests::transforms_bytes({{"base", "laser", {0.2, 0, 0, 0, 0, 0, 1}}}, stamp_s);
  };
  for (int second = 20; second < 40; ++second)  // stamps go four times slower than the clock
    stream.take(received(kTf, second, link(1 + 0.25 * (second - 20))));
  CHECK_FALSE(stream.is_open());
  stream.take(received(kTf, 41, link(6.25)));
  REQUIRE(stream.is_open());
  CHECK(stream.mounts().at(0).T_parent_child.x() == Approx(0.2));
}
