#pragma once

#include <opal/recording/ros_log.hpp>

namespace opal::mcap_log {

/// MCAP files with messages of ROS 2 (CDR) or ROS 1: one file, or the folder of a recording with all of its .mcap
/// files.
class McapLog final : public recording::RosLogSource {
 public:
  explicit McapLog(recording::TopicChoice topics) : RosLogSource(std::move(topics)) {}

  bool recognizes(const std::string& path) const override;

 protected:
  recording::Parts parts_of(const std::string& path) const override;
  std::string format() const override { return "MCAP recording"; }
};

}  // namespace opal::mcap_log
