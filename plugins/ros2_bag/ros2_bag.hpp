#pragma once

#include <opal/sensing/log_source.hpp>

#include <string>

namespace opal::ros2_bag {

/// Which topics to read; empty: the only one of its type, or the one of the usual name (/scan, /odom).
struct TopicChoice {
  std::string scan;
  std::string odometry;
};

/// ROS 2 recordings (rosbag2, sqlite3 storage, CDR): one .db3 file, or the folder of a recording with all of its
/// .db3 files. Before anything else the reader tells where the laser is mounted, if /tf_static says so.
class Ros2Bag final : public LogSource {
 public:
  explicit Ros2Bag(TopicChoice topics) : topics_(std::move(topics)) {}

  bool recognizes(const std::string& path) const override;
  std::unique_ptr<LogReader> open(const std::string& path) const override;

 private:
  TopicChoice topics_;
};

}  // namespace opal::ros2_bag
