#pragma once

#include <opal/recording/ros_log.hpp>

namespace opal::ros1_bag {

/// Bags of ROS 1 (format 2.0): one .bag file, or a folder with the .bag files that one recording was split into.
class Ros1Bag final : public recording::RosLogSource {
 public:
  explicit Ros1Bag(recording::TopicChoice topics) : RosLogSource(std::move(topics)) {}

 protected:
  bool recognizes_file(const std::string& file) const override;
  std::unique_ptr<recording::Recording> read(const std::string& file) const override;
  std::string format() const override { return "ROS 1 bag"; }
  std::string ending() const override { return ".bag"; }
};

}  // namespace opal::ros1_bag
