// A drive through a building with a 3D lidar on the robot, from messages to poses.
#include "cloud_message.hpp"
#include "plugins/mcap_log/mcap_log.hpp"
#include "recording/cloud_slicer.hpp"
#include "recording/containers/mcap_writer.hpp"
#include "recording/ros_stream.hpp"
#include "tests/kit/temporary_folder.hpp"
#include "tests/live/live_robot.hpp"

#include <opal/recording/ros_log.hpp>
#include <opal/sensing/replay.hpp>

#include <catch2/catch.hpp>

#include <span>
#include <sstream>

using namespace opal;
using namespace opal::recording;
using namespace opal::recording_tests;

namespace {

constexpr double kEpoch_s = 1000;  // a stamp of 0 is none
constexpr double kMostRange_m = 79;
const std::string kTopic = "/points";

/// The front laser of the robot, as a lidar that is tilted and stands higher.
LaserModel lidar_of(const LaserModel& laser) {
  LaserModel lidar = laser;
  lidar.frame = "lidar";
  lidar.topic = kTopic;
  lidar.sweep_s.reset();
  lidar.slice = CloudSlice{0.3, 1.8, 1.1, -0.05, 0.1};
  return lidar;
}

/// In whole microseconds: the writers of messages round fractions of a second, and know no carry.
double stamp_of(double log_s) { return std::round(1e6 * (log_s + kEpoch_s)) / 1e6; }

/// What a lidar of a few rings sees where a planar laser sees walls: the walls at several heights, floor and ceiling in
/// front of them, a lamp, and nothing where the laser met nothing.
std::string cloud_message(const RawScan& scan, const LaserModel& lidar) {
  const Eigen::Isometry3d T_sensor_base = described_mount(lidar).inverse();
  const double beam_s = 0.03 / (lidar.beams - 1);
  struct Thing {
    double share_of_range, height_m;
  };
  const std::vector<Thing> things{{1, 0.35}, {1, 0.9}, {1, 1.7}, {0.7, 0}, {0.8, 2.7}, {0.5, 2.2}};
  CloudMessage made;
  made.stamp_s = stamp_of(scan.stamp_s);
  made.time_name = "t";
  made.height = static_cast<std::uint32_t>(things.size());
  for (const Thing& thing : things)
    for (std::size_t k = 0; k < scan.ranges_m.size(); ++k) {
      const double range_m = scan.ranges_m[k] < kMostRange_m ? double{scan.ranges_m[k]} : std::nan("");
      const double bearing_rad = lidar.angle_min_rad + static_cast<double>(k) * lidar.angle_increment_rad;
      const Point on_floor = lidar.T_base_laser * Point(thing.share_of_range * range_m * unit_vector(bearing_rad));
      const Eigen::Vector3d seen = T_sensor_base * Eigen::Vector3d(on_floor.x(), on_floor.y(), thing.height_m);
      made.points.push_back({seen.x(), seen.y(), seen.z(), std::round(1e9 * beam_s * static_cast<double>(k))});
    }
  return made.bytes();
}

const LiveRobot& short_robot() {
  static const LiveRobot one(40);
  return one;
}

ReceivedMessage odometry_message(const OdometryRecord& odometry) {
  const Pose2& pose = odometry.T_odom_base;
  const std::string bytes = log_tests::odometry_bytes(
      stamp_of(odometry.stamp_s),
      {pose.x(), pose.y(), 0, 0, 0, std::sin(pose.heading_rad() / 2), std::cos(pose.heading_rad() / 2)});
  const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
  return {{"/odom", "nav_msgs/msg/Odometry", Wire::cdr},
          static_cast<std::int64_t>(stamp_of(odometry.stamp_s) * 1e9),
          {data, data + bytes.size()}};
}

ReceivedMessage cloud_of(const RawScan& scan, const LaserModel& lidar) {
  const std::string bytes = cloud_message(scan, lidar);
  const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
  return {{kTopic, "sensor_msgs/msg/PointCloud2", Wire::cdr},
          static_cast<std::int64_t>((scan.stamp_s + 0.04 + kEpoch_s) * 1e9),
          {data, data + bytes.size()}};
}

std::vector<LogRecord> planar_records() {
  std::vector<LogRecord> records;
  for (const LogRecord& record : simulation::records_of(short_robot().recording)) {
    const auto* scan = std::get_if<RawScan>(&record);
    if (scan && scan->frame != short_robot().lasers.front().frame) continue;
    records.push_back(record);
    if (scan) std::get<RawScan>(records.back()).T_odom_base.reset();
  }
  return records;
}

const std::vector<ReceivedMessage>& messages() {
  static const std::vector<ReceivedMessage> all = [] {
    std::vector<ReceivedMessage> made;
    for (const LogRecord& record : planar_records()) {
      if (const auto* odometry = std::get_if<OdometryRecord>(&record)) made.push_back(odometry_message(*odometry));
      if (const auto* scan = std::get_if<RawScan>(&record))
        made.push_back(cloud_of(*scan, lidar_of(short_robot().lasers.front())));
    }
    return made;
  }();
  return all;
}

std::string recorded() {
  std::ostringstream out;
  McapWriter writer(out, "clouds.mcap", {"ros2", "", 1 << 20, 1'000'000'000});
  const auto channel = [&](const std::string& topic, const std::string& type) {
    return writer.add_channel(topic, writer.add_schema(type, "ros2msg", ""), "cdr");
  };
  const auto clouds = channel(kTopic, "sensor_msgs/msg/PointCloud2"),
             odometry = channel("/odom", "nav_msgs/msg/Odometry");
  for (const ReceivedMessage& message : messages())
    writer.write(message.topic.name == kTopic ? clouds : odometry, 0, message.received_ns, message.received_ns,
                 message.bytes());
  writer.finish();
  return out.str();
}

struct Driven {
  int answers = 0, localized = 0;
  double farthest_m = 0;  // of localized answers from the truth
};

Driven driven(const std::vector<LogRecord>& records, const LaserModel& laser, double epoch_s) {
  Localizer localizer(short_robot().parts({laser}), nullptr);
  Replay replay(records, {laser});
  Driven drive;
  while (const auto sample = replay.next()) {
    localizer.update(*sample);
    const PoseEstimate estimate = localizer.estimate_at(sample->stamp_s, sample->T_odom_base);
    ++drive.answers;
    if (estimate.status != Status::localized) continue;
    ++drive.localized;
    drive.farthest_m =
        std::max(drive.farthest_m, distance_m(estimate.T_map_base, short_robot().truth_at(sample->stamp_s - epoch_s)));
  }
  return drive;
}

}  // namespace

TEST_CASE("a drive with a tilted 3D lidar is localized like the same drive with a planar laser") {
  const LaserModel planar = short_robot().lasers.front(), lidar = lidar_of(planar);
  const TemporaryFile file("clouds.mcap", recorded());
  const auto reader = mcap_log::McapLog({}).open_for(file.path(), {lidar});
  const std::vector<LogRecord> sliced = read_all(*reader);
  const Driven by_laser = driven(planar_records(), planar, 0), by_lidar = driven(sliced, lidar, kEpoch_s);
  CHECK(by_lidar.answers == by_laser.answers);
  CHECK(by_laser.localized > by_laser.answers / 2);
  CHECK(by_lidar.localized > 0.9 * by_laser.localized);
  CHECK(by_laser.farthest_m < 0.3);
  CHECK(by_lidar.farthest_m < 0.3);
}

TEST_CASE("a slice of a cloud has the ranges of a planar laser at its place") {
  const LaserModel lidar = lidar_of(short_robot().lasers.front());
  const TemporaryFile file("clouds.mcap", recorded());
  const std::vector<LogRecord> planar = planar_records();
  const auto reader = mcap_log::McapLog({}).open_for(file.path(), {lidar});
  const std::vector<LogRecord> sliced = read_all(*reader);
  REQUIRE(sliced.size() == planar.size());
  int compared = 0, different = 0;
  for (std::size_t i = 0; i < planar.size(); ++i) {
    if (planar[i].index() != 1) continue;
    const RawScan &scan = std::get<RawScan>(planar[i]), &slice = std::get<RawScan>(sliced[i]);
    REQUIRE(slice.ranges_m.size() == scan.ranges_m.size());
    CHECK(slice.frame == "lidar");
    for (std::size_t k = 0; k < scan.ranges_m.size(); ++k) {
      const bool is_hit = scan.ranges_m[k] < kMostRange_m && scan.ranges_m[k] >= 0.06f;
      if (!is_hit) continue;
      ++compared;
      // Beams that point to the border between two bins may fall to either side of it.
      different += std::abs(slice.ranges_m[k] - scan.ranges_m[k]) < 1e-3 ? 0 : 1;
    }
  }
  CHECK(compared > 10'000);
  CHECK(different < compared / 1000);
}

TEST_CASE("a stream of clouds gives the records that a recording of them gives") {
  const LaserModel lidar = lidar_of(short_robot().lasers.front());
  const TemporaryFile file("clouds.mcap", recorded());
  const auto reader = mcap_log::McapLog({}).open_for(file.path(), {lidar});
  const std::vector<LogRecord> replayed = read_all(*reader);
  TopicChoice choice = with_topics_of({}, {lidar});
  choice.odometry = "/odom";
  RosStream stream(choice, 0);
  CHECK(stream.waits_for() == "scans on /points, odometry on /odom");
  std::vector<LogRecord> live;
  for (const ReceivedMessage& message : messages()) {
    stream.take(message);
    while (const auto next = stream.next())
      if (next->record) live.push_back(*next->record);
  }
  REQUIRE(live.size() == replayed.size());
  for (std::size_t i = 0; i < live.size(); ++i) {
    REQUIRE(live[i].index() == replayed[i].index());
    if (live[i].index() != 1) continue;
    const RawScan &one = std::get<RawScan>(live[i]), &other = std::get<RawScan>(replayed[i]);
    REQUIRE(one.stamp_s == other.stamp_s);
    REQUIRE(one.beam_times_s == other.beam_times_s);
  }
}

TEST_CASE("the contents of a recording of clouds tell fields, extents and the heights between floor and ceiling") {
  const TemporaryFile file("clouds.mcap", recorded());
  const LogContents contents = mcap_log::McapLog({}).contents(file.path());
  CHECK(contents.lasers.empty());
  REQUIRE(contents.clouds.size() == 1);
  const LogCloud& cloud = contents.clouds.front();
  CHECK(cloud.topic == kTopic);
  CHECK(cloud.height == 6);
  CHECK(cloud.width == 381);
  CHECK(cloud.fields == std::vector<std::string>{"intensity UINT8", "x FLOAT32", "y FLOAT32", "z FLOAT32", "t UINT32"});
  CHECK(cloud.time_field == "t");
  CHECK(cloud.sweep_s == Approx(0.03).margin(1e-3));
  CHECK_FALSE(cloud.mount);
  REQUIRE(cloud.suggested);  // seen from the sensor, 1.1 m above the floor
  CHECK(cloud.suggested->z_min_m < 0.5 - 1.1);
  CHECK(cloud.suggested->z_max_m > 0.2);
}

TEST_CASE("a recording without scans says that its point clouds can be read") {
  const TemporaryFile file("clouds.mcap", recorded());
  const std::string hint =
      "there are point clouds (/points): the deployment has to describe a slice of them (sensor.slice)";
  CHECK_THROWS_WITH(mcap_log::McapLog({}).open(file.path()), Catch::Contains(hint));
  TopicChoice named;
  named.scans = {kTopic};
  CHECK_THROWS_WITH(mcap_log::McapLog(named).open(file.path()), Catch::Contains("/points has no scans; " + hint));
  LaserModel elsewhere = lidar_of(short_robot().lasers.front());
  elsewhere.topic = "/other";
  CHECK_THROWS_WITH(
      mcap_log::McapLog({}).open_for(file.path(), {elsewhere}),
      Catch::Contains("no topic /other of type sensor_msgs/PointCloud2 that can be read, there is /points"));
}
