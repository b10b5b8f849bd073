#pragma once

#include <opal/sensing/log_source.hpp>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace opal::ros2_bag {

using Bytes = std::span<const std::byte>;

/// geometry_msgs/msg/TransformStamped. A stamp of 0 is one that was never set.
struct Transform {
  double stamp_s = 0;
  std::string parent;
  std::string child;
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();
};

/// nav_msgs/msg/Odometry, as far as it is used.
struct OdometryMessage {
  OdometryRecord odometry;  ///< the pose's projection on the floor
  std::string base_frame;
};

/// sensor_msgs/msg/LaserScan with its own geometry. Readings below its range_min become NaN and those above its
/// range_max infinite (ROS enhancement proposal 117). A stamp of 0 is one that was never set: it is left to the caller.
/// @return nullopt for a damaged message.
std::optional<RawScan> decode_laser_scan(Bytes message);
/// @return nullopt for a damaged message, or one whose pose is none.
std::optional<OdometryMessage> decode_odometry(Bytes message);
/// tf2_msgs/msg/TFMessage. @return nullopt for a damaged message.
std::optional<std::vector<Transform>> decode_transforms(Bytes message);

/// The projection of a pose on the floor: where its x axis points.
Pose2 projected(const Eigen::Isometry3d& pose);

}  // namespace opal::ros2_bag
