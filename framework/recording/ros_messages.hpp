#pragma once

#include <opal/recording/recording.hpp>
#include <opal/sensing/log_source.hpp>

#include <Eigen/Geometry>

namespace opal::recording {

/// sensor_msgs/LaserScan.
struct LaserScanMessage {
  /// With its own geometry. Readings below range_min are NaN and those above range_max infinite (ROS enhancement
  /// proposal 117). A stamp of 0 is one that was never set: it is left to the caller.
  RawScan scan;
  double range_min_m = 0;  ///< as stated
  double range_max_m = 0;  ///< as stated
  double scan_time_s = 0;  ///< from one scan to the next; 0: not stated
};
/// nav_msgs/Odometry, as far as it is used.
struct OdometryMessage {
  OdometryRecord odometry;  ///< the pose's projection on the floor
  std::string odom_frame;   ///< in which the pose is given
  std::string base_frame;   ///< whose pose it is
};
/// geometry_msgs/PoseWithCovarianceStamped, as somebody says where the robot is.
struct HintMessage {
  HintRecord hint;    ///< a covariance of zeros is replaced by that of RViz; a stamp of 0 is one that was never set
  std::string frame;  ///< in which the pose is given
};
/// geometry_msgs/TransformStamped. A stamp of 0 is one that was never set.
struct Transform {
  double stamp_s = 0;                                                ///< by the clock of the log
  std::string parent;                                                ///< frame in which the pose is given
  std::string child;                                                 ///< frame that is placed
  Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();  ///< where it lies
};

/// @return nullopt for a damaged message.
std::optional<LaserScanMessage> decode_laser_scan(Bytes message, Wire wire);
/// @return nullopt for a damaged message, or one whose pose is none.
std::optional<OdometryMessage> decode_odometry(Bytes message, Wire wire);
/// @return nullopt for a damaged message, or one whose pose is none.
std::optional<HintMessage> decode_hint(Bytes message, Wire wire);
/// rosgraph_msgs/Clock, in seconds. @return nullopt for a damaged message.
std::optional<double> decode_clock(Bytes message, Wire wire);
/// tf2_msgs/TFMessage and tf/tfMessage. A transform whose numbers are no pose is left out: the others of its message
/// are whole.
/// @param left_out  counts those, each by its frames; may be null.
/// @return nullopt for a damaged message.
std::optional<std::vector<Transform>> decode_transforms(Bytes message, Wire wire, Defects* left_out = nullptr);

/// The projection of a pose on the floor: where its x axis points.
Pose2 projected(const Eigen::Isometry3d& pose);
/// Old drivers write "/base_link" for "base_link".
std::string without_slash(const std::string& frame);

/// Whether a topic has messages of this type that can be decoded. @param type  as ROS 1 writes it.
bool has_type(const Topic& topic, const std::string& type);
/// Whether a topic has laser scans.
bool has_scans(const Topic& topic);
/// Whether a topic has point clouds.
bool has_clouds(const Topic& topic);
/// Whether a topic has odometry.
bool has_odometry(const Topic& topic);
/// Whether a topic has poses that somebody says.
bool has_hints(const Topic& topic);
/// Whether a topic has transforms; those that change (/tf) or those that do not (/tf_static).
bool has_transforms(const Topic& topic, bool are_static);

}  // namespace opal::recording
