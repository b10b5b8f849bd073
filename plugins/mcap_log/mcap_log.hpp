#pragma once

#include <opal/recording/ros_log.hpp>

namespace opal::mcap_log {

/// MCAP files with messages of ROS 2 (CDR) or ROS 1: one file, or the folder of a recording with all of its .mcap
/// files.
class McapLog final : public recording::RosLogSource {
 public:
  explicit McapLog(recording::TopicChoice topics) : RosLogSource(std::move(topics)) {}

 protected:
  bool recognizes_file(const std::string& file) const override;
  std::unique_ptr<recording::Recording> read(const std::string& file) const override;
  std::string format() const override { return "MCAP recording"; }
  std::string ending() const override { return ".mcap"; }
};

}  // namespace opal::mcap_log
