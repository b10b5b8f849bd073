#include "plugins/ros1_bag/ros1_bag.hpp"
#include "ros1_writer.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/sensing/replay.hpp>
#include "plugins/ros1_bag/bag_recording.hpp"

#include <catch2/catch.hpp>

#include <sstream>

namespace {

using namespace opal;
using namespace opal::log_tests;

/// A drive of `seconds` with a scan, a pose and the mount in each; two seconds make a chunk.
Ros1BagWriter drive(const std::string& compression, int seconds) {
  Ros1BagWriter bag(compression);
  const auto scans = bag.connection("/front", "sensor_msgs/LaserScan");
  const auto odometry = bag.connection("/odom", "nav_msgs/Odometry");
  const auto transforms = bag.connection("/tf", "tf/tfMessage");
  for (int second = 1; second <= seconds; ++second) {
    bag.message(odometry, second, ros1_odometry(second, 0.1 * second));
    bag.message(transforms, second, ros1_transform(second, "odom", "base_link", 0.1 * second));
    bag.message(transforms, second + 0.1, ros1_transform(second, "/base_link", "laser", 0.4));
    bag.message(scans, second + 0.2, ros1_scan(second, {1, 2, 3}));
    if (second % 2 == 0) bag.end_chunk();
  }
  return bag;
}

struct WalkedRos1Bag {
  int scans = 0, poses = 0;
  std::vector<MountRecord> mounts;
  std::map<std::string, int> defects;
};

WalkedRos1Bag walk_ros1_bag(const std::string& bytes, const recording::TopicChoice& topics = {}) {
  const TemporaryFile file("a.bag", bytes);
  const auto reader = ros1_bag::Ros1Bag(topics).open(file.path());
  WalkedRos1Bag walked;
  while (const auto record = reader->next()) {
    walked.scans += std::holds_alternative<RawScan>(*record) ? 1 : 0;
    walked.poses += std::holds_alternative<OdometryRecord>(*record) ? 1 : 0;
    if (const auto* mount = std::get_if<MountRecord>(&*record)) walked.mounts.push_back(*mount);
  }
  walked.defects = reader->defects();
  return walked;
}

std::vector<std::string> messages_of(const std::string& bytes, recording::Defects* defects = nullptr) {
  const auto bag = ros1_bag::read_bag(std::make_unique<std::istringstream>(bytes), "a.bag");
  std::vector<std::size_t> topics;
  for (std::size_t i = 0; i < bag->topics().size(); ++i) topics.push_back(i);
  const auto walk = bag->walk(topics);
  std::vector<std::string> messages;
  while (const auto message = walk->next())
    messages.emplace_back(reinterpret_cast<const char*>(message->data.data()), message->data.size());
  if (defects) *defects = bag->defects();
  for (const auto& [cause, times] : walk->defects())
    if (defects) (*defects)[cause] += times;
  return messages;
}

}  // namespace

TEST_CASE("scans, odometry and the mount of a bag of ROS 1 become records, packed or not") {
  const std::string compression = GENERATE("none", "bz2");
  CAPTURE(compression);
  const WalkedRos1Bag walked = walk_ros1_bag(drive(compression, 7).closed());
  CHECK(walked.defects.empty());
  CHECK(walked.scans == 7);
  CHECK(walked.poses == 7);
  REQUIRE(walked.mounts.size() == 1);  // stated by /tf, where it does not move
  CHECK(walked.mounts[0].parent == "base_link");
  CHECK(walked.mounts[0].T_parent_child.x() == Approx(0.4));
}

TEST_CASE("a bag that was never closed is read without its index, and this is told") {
  const WalkedRos1Bag walked = walk_ros1_bag(drive("bz2", 6).bytes());
  CHECK(walked.scans == 6);
  CHECK(walked.defects == std::map<std::string, int>{{"the bag was never closed: it is read without its index", 1}});
}

TEST_CASE("wherever a bag is cut, its whole messages are read and the cut is told") {
  const std::string compression = GENERATE("none", "bz2");
  CAPTURE(compression);
  const std::string whole = drive(compression, 4).closed();
  const std::vector<std::string> all = messages_of(whole);
  REQUIRE(all.size() == 16);
  for (std::size_t length = 13; length < whole.size(); ++length) {
    CAPTURE(length);
    recording::Defects defects;
    const std::vector<std::string> cut = messages_of(whole.substr(0, length), &defects);
    REQUIRE(cut.size() <= all.size());
    REQUIRE(std::equal(cut.begin(), cut.end(), all.begin()));
    REQUIRE_FALSE((defects.empty() && cut.size() < all.size()));
  }
}

TEST_CASE("bytes that are no record are left out with their place, and the next record is found") {
  Ros1BagWriter writer = drive("none", 4);
  const std::size_t hole_at = writer.bytes().size();
  const std::string closed = writer.closed();
  const std::string damaged = closed.substr(0, hole_at) + std::string(49, '\0') + closed.substr(hole_at);
  recording::Defects defects;
  CHECK(messages_of(damaged, &defects).size() == 16);
  CHECK(defects == recording::Defects{{"no whole record at byte " + std::to_string(hole_at) +
                                           ": 49 bytes are left out, expected a record of a bag",
                                       1}});
}

TEST_CASE("a damaged chunk costs its messages only") {
  std::string bytes = drive("bz2", 6).closed();
  const std::size_t second = bytes.find("BZh9", bytes.find("BZh9") + 1);
  bytes[second + 30] = static_cast<char>(bytes[second + 30] ^ 0x40);
  recording::Defects defects;
  CHECK(messages_of(bytes, &defects).size() == 16);
  REQUIRE(defects.size() == 1);
  CHECK_THAT(defects.begin()->first,
             Catch::StartsWith("message in a damaged chunk at byte ") && Catch::Contains("bz2"));
  CHECK(defects.begin()->second == 8);
}

TEST_CASE("of several lasers that nobody chose between, the first by name is read, and this is told") {
  Ros1BagWriter bag;
  const auto rear = bag.connection("/rear", "sensor_msgs/LaserScan");
  const auto front = bag.connection("/front", "sensor_msgs/LaserScan");
  bag.message(rear, 1, ros1_scan(1, {1, 2}, "rear_laser"));
  bag.message(front, 2, ros1_scan(2, {1, 2, 3}, "front_laser"));
  bag.message(rear, 3, ros1_scan(3, {1, 2}, "rear_laser"));
  const WalkedRos1Bag usual = walk_ros1_bag(bag.closed());
  CHECK(usual.scans == 1);
  CHECK(usual.defects.count("several lasers (/front, /rear): /front is read, the option scan_topic may name another "
                            "one") == 1);
  recording::TopicChoice choice;
  choice.scans = {"/rear"};
  const WalkedRos1Bag asked = walk_ros1_bag(bag.closed(), choice);
  CHECK(asked.scans == 2);
  for (const auto& [cause, times] : asked.defects) CHECK_THAT(cause, !Catch::Contains("several lasers"));
}

TEST_CASE("topics in a list stand between commas or blanks") {
  for (const std::string list : {"/rear,/front", "/rear /front", " /rear,  /front,"})
    CHECK(recording::topic_choice({{"scan_topic", ""},
                                   {"scan_topics", list},
                                   {"odometry_topic", ""},
                                   {"odom_frame", "odom"},
                                   {"base_frame", ""}})
              .scans == std::vector<std::string>{"/rear", "/front"});
}

TEST_CASE("several lasers that were asked for are read together, and tell apart by their frames") {
  Ros1BagWriter bag;
  const auto rear = bag.connection("/rear", "sensor_msgs/LaserScan");
  const auto front = bag.connection("/front", "sensor_msgs/LaserScan");
  bag.message(rear, 1, ros1_scan(1, {1, 2}, "rear_laser"));
  bag.message(front, 2, ros1_scan(2, {1, 2, 3}, "front_laser"));
  const recording::TopicChoice both = recording::topic_choice({{"scan_topic", ""},
                                                               {"scan_topics", "/rear, /front"},
                                                               {"odometry_topic", ""},
                                                               {"odom_frame", "odom"},
                                                               {"base_frame", ""}});
  CHECK(both.scans == std::vector<std::string>{"/rear", "/front"});
  const WalkedRos1Bag walked = walk_ros1_bag(bag.closed(), both);
  CHECK(walked.scans == 2);
  for (const auto& [cause, times] : walked.defects) CHECK_THAT(cause, !Catch::Contains("several lasers"));
}

TEST_CASE("the contents of a bag name all lasers with their mounts, and what is read") {
  const TemporaryFile file("a.bag", drive("bz2", 7).closed());
  const LogContents contents = ros1_bag::Ros1Bag({}).contents(file.path());
  CHECK(contents.format == "ROS 1 bag");
  REQUIRE(contents.topics.size() == 3);
  CHECK(contents.topics[0].name == "/front");
  CHECK(contents.topics[0].messages == 7);
  CHECK(contents.topics[0].interval_s == Approx(1));
  REQUIRE(contents.lasers.size() == 1);
  CHECK(contents.lasers[0].is_read);
  CHECK(contents.lasers[0].sweep_s == Approx(0.02));
  REQUIRE(contents.lasers[0].mount);
  CHECK(contents.lasers[0].mount->from_moving_topic);
  REQUIRE(contents.odometries.size() == 2);  // the topic, and the transforms
  CHECK(contents.odometries[0].is_read);
  CHECK(contents.odometries[0].driven_m == Approx(0.6));
  CHECK(contents.odometries[0].recorded_after_s == Approx(0).margin(1e-6));
  CHECK(contents.options ==
        std::vector<std::pair<std::string, std::string>>{{"scan_topic", "/front"}, {"odometry_topic", "/odom"}});
}

TEST_CASE("what is no bag of ROS 1 is not recognized, and refused by name") {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.path(), folder.path_of("missing.bag"), folder.write("empty.bag", ""),
                                  folder.write("old.bag", "#ROSBAG V1.2\n")}) {
    INFO(path);
    CHECK_FALSE(ros1_bag::Ros1Bag({}).recognizes(path));
    CHECK_THROWS_AS(ros1_bag::Ros1Bag({}).open(path), LogError);
    CHECK_THROWS_WITH(ros1_bag::Ros1Bag({}).open(path), Catch::StartsWith(path));
  }
}

TEST_CASE("a chunk that says it is larger than any is damaged, however it is packed") {
  const std::string compression = GENERATE("none", "bz2");
  CAPTURE(compression);
  std::string bytes = drive(compression, 6).closed();
  const std::string size_field = "size=";
  const std::size_t size = bytes.find(size_field) + size_field.size();
  for (std::size_t k = 0; k < 4; ++k) bytes[size + k] = static_cast<char>(0xF0);
  recording::Defects defects;
  CHECK(messages_of(bytes, &defects).size() < 24);
  CHECK_FALSE(defects.empty());
}
