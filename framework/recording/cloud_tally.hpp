#pragma once

#include "recording/point_cloud.hpp"
#include "recording/ros_topics.hpp"

#include <Eigen/Geometry>

namespace opal::recording {

/// What the point clouds of one topic have in common, by some points of a few clouds.
class CloudTally {
 public:
  /// Clouds that are enough.
  static constexpr int kEnough = 20;

  void add(const PointCloudMessage& cloud);
  bool is_full() const { return cloud_.clouds >= kEnough; }
  const std::string& frame() const { return cloud_.frame; }
  /// @param T_base_sensor  where the sensor is, if that is known; else what is told is in its own frame.
  LogCloud told(const std::string& topic, const std::optional<Eigen::Isometry3d>& T_base_sensor) const;

 private:
  LogCloud cloud_;
  std::vector<Eigen::Vector3d> points_;
  double looked_at_ = 0;
};

/// Looks at the first clouds of each topic. What cannot be read is counted.
std::map<std::string, CloudTally> tally_clouds(const Parts& parts, Defects& defects);

}  // namespace opal::recording
