// Recordings whose odometry is in their transforms.
#include "bag_writer.hpp"
#include "tests/kit/temporary_folder.hpp"

#include <opal/sensing/replay.hpp>
#include "plugins/ros2_bag/ros2_bag.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

using namespace opal;
using namespace opal::log_tests;

const std::vector<double> kSamePose{0, 0, 0, 0, 0, 0, 1};

struct ReadRecording {
  std::vector<LogRecord> records;
  std::map<std::string, int> defects;
};

ReadRecording read_recording(const TemporaryFolder& folder, const recording::TopicChoice& choice = {}) {
  const auto reader = ros2_bag::Ros2Bag(choice).open(folder.path_of("a.db3"));
  ReadRecording recording{read_all(*reader), {}};
  recording.defects = reader->defects();
  return recording;
}

std::string still_scan(double stamp_s) {
  LaserScanMessage scan;
  scan.stamp_s = stamp_s;
  return scan.bytes();
}

}  // namespace

TEST_CASE("transforms are the odometry of a recording without a topic for it, and mount the laser") {
  const TemporaryFolder folder;
  {
    BagWriter bag(folder.path_of("a.db3"));
    const int scans = bag.scans(), transforms = bag.transforms();
    bag.message(bag.static_transforms(), 1, transforms_bytes({{"base_footprint", "laser", {0.3, 0, 1, 0, 0, 0, 1}}}));
    bag.message(transforms, 1, transforms_bytes({{"base_footprint", "wheel", kSamePose}}, 1));
    bag.message(scans, 2, still_scan(2));
    bag.message(transforms, 3,
                transforms_bytes({{"map", "odom", {9, 9, 0, 0, 0, 0, 1}},
                                  {"/odom", "base_footprint", {1, 2, 0, 0, 0, std::sqrt(0.5), std::sqrt(0.5)}}},
                                 2.5));
  }
  const ReadRecording walked = read_recording(folder);
  CHECK(walked.defects.empty());
  REQUIRE(walked.records.size() == 3);
  CHECK(std::get<MountRecord>(walked.records[0]).T_parent_child.x() == Approx(0.3));
  CHECK(std::holds_alternative<RawScan>(walked.records[1]));
  const auto& odometry = std::get<OdometryRecord>(walked.records[2]);
  CHECK(odometry.stamp_s == Approx(2.5));
  CHECK(odometry.T_odom_base.y() == Approx(2));
  CHECK(odometry.T_odom_base.heading_rad() == Approx(std::acos(0.0)));
}

TEST_CASE("transforms between other frames are named where there is no odometry, and are odometry if asked for") {
  const TemporaryFolder folder;
  {
    BagWriter bag(folder.path_of("a.db3"));
    bag.message(bag.scans(), 1, still_scan(1));
    bag.message(bag.transforms(), 1, transforms_bytes({{"wheel_odom", "robot", kSamePose}}));
  }
  const ReadRecording without = read_recording(folder);
  CHECK(without.records.size() == 1);
  CHECK(without.defects.count("no odometry: no topic has it, and no transform from odom; the options odom_frame and "
                              "base_frame may name one of wheel_odom to robot") == 1);
  CHECK_THROWS_WITH(read_recording(folder, {{}, "/odom"}),
                    Catch::Contains("there is none; without the option odometry_topic it is taken from /tf"));
  const ReadRecording asked = read_recording(folder, {{}, "", "/wheel_odom", "robot"});
  CHECK(asked.records.size() == 2);
}
