#pragma once

#include <opal/sensing/log_source.hpp>

#include <string>

namespace opal::ros2_bag {

/// What to read of a recording.
struct TopicChoice {
  std::string scan;                 ///< topic; empty: the only one of its type, or the one of the usual name (/scan)
  std::string odometry;             ///< the same (/odom)
  std::string odom_frame = "odom";  ///< where no topic has odometry: the transforms from this frame are it,
  std::string base_frame = {};      ///< to this one; empty: to the first that a transform leads to
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
