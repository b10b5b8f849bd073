#pragma once

#include <opal/recording/ros_log.hpp>

namespace opal::ros2_bag {

/// ROS 2 recordings (rosbag2, sqlite3 storage, CDR): one .db3 file, or the folder of a recording with all of its
/// .db3 files.
class Ros2Bag final : public recording::RosLogSource {
 public:
  explicit Ros2Bag(recording::TopicChoice topics) : RosLogSource(std::move(topics)) {}

 protected:
  bool recognizes_file(const std::string& file) const override;
  std::unique_ptr<recording::Recording> read(const std::string& file) const override;
  std::string format() const override { return "ROS 2 bag (sqlite3)"; }
  std::string ending() const override { return ".db3"; }
};

}  // namespace opal::ros2_bag
