#include "recording/ros_messages.hpp"
#include "recording/wire_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace opal::recording {
namespace {

constexpr std::size_t kMostReadings = 100'000;
constexpr double kFarthest_m = 1e7;
// What "2D Pose Estimate" of RViz sends.
constexpr double kRvizSigma_m = 0.5, kRvizSigma_rad = 0.26;
constexpr std::size_t kVarianceX = 0, kVarianceY = 7, kVarianceHeading = 35;

/// Position and quaternion (x y z w), as in geometry_msgs/msg/Pose and Transform.
/// @return nullopt if they are no pose; or there are too few bytes, which the reader tells.
std::optional<Eigen::Isometry3d> read_pose(WireReader& wire) {
  double values[7];
  for (double& value : values) value = wire.number<double>();
  const Eigen::Vector3d position(values[0], values[1], values[2]);
  const Eigen::Quaterniond turn(values[6], values[3], values[4], values[5]);
  const double norm = turn.norm();
  const bool usable = position.allFinite() && position.cwiseAbs().maxCoeff() < kFarthest_m && norm > 0.5 && norm < 2;
  if (!wire.ok() || !usable) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = turn.normalized().toRotationMatrix();
  pose.translation() = position;
  return pose;
}

double sigma_of(double variance, double otherwise) {
  return std::isfinite(variance) && variance > 0 ? std::sqrt(variance) : otherwise;
}

void mark_out_of_range(std::vector<float>& ranges_m, float range_min_m, float range_max_m) {
  if (!(range_min_m >= 0 && range_max_m > range_min_m)) return;
  for (float& range_m : ranges_m) {
    if (range_m < range_min_m) range_m = std::numeric_limits<float>::quiet_NaN();
    if (range_m > range_max_m) range_m = std::numeric_limits<float>::infinity();
  }
}

}  // namespace

Pose2 projected(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d forward = pose.linear().col(0);
  return {pose.translation().head<2>(), std::atan2(forward.y(), forward.x())};
}

std::string without_slash(const std::string& frame) { return frame.starts_with('/') ? frame.substr(1) : frame; }

std::optional<LaserScanMessage> decode_laser_scan(Bytes message, Wire wire) {
  WireReader reader(message, wire);
  const std::optional<MessageHeader> header = read_header(reader);
  if (!header) return std::nullopt;
  LaserScanMessage laser;
  RawScan& scan = laser.scan;
  scan.stamp_s = header->stamp_s;
  scan.frame = header->frame;
  scan.angle_min_rad = reader.number<float>();
  reader.skip_numbers(1, sizeof(float));  // angle_max: follows from the number of readings
  scan.angle_increment_rad = reader.number<float>();
  scan.time_increment_s = reader.number<float>();
  laser.scan_time_s = reader.number<float>();
  laser.range_min_m = reader.number<float>();
  laser.range_max_m = reader.number<float>();
  scan.ranges_m.resize(std::min(reader.length(sizeof(float)), kMostReadings + 1));
  for (float& range_m : scan.ranges_m) range_m = reader.number<float>();
  const bool has_angles =
      std::abs(*scan.angle_min_rad) < 10 && std::abs(*scan.angle_increment_rad) < 10 && *scan.angle_increment_rad != 0;
  if (!reader.ok() || !has_angles || scan.ranges_m.size() > kMostReadings) return std::nullopt;
  mark_out_of_range(scan.ranges_m, static_cast<float>(laser.range_min_m), static_cast<float>(laser.range_max_m));
  return laser;
}

std::optional<OdometryMessage> decode_odometry(Bytes message, Wire wire) {
  WireReader reader(message, wire);
  const std::optional<MessageHeader> header = read_header(reader);
  if (!header) return std::nullopt;
  std::string base_frame = reader.text();
  const std::optional<Eigen::Isometry3d> T_odom_base = read_pose(reader);
  if (!T_odom_base) return std::nullopt;
  return OdometryMessage{{header->stamp_s, projected(*T_odom_base)}, header->frame, std::move(base_frame)};
}

std::optional<HintMessage> decode_hint(Bytes message, Wire wire) {
  WireReader reader(message, wire);
  const std::optional<MessageHeader> header = read_header(reader);
  if (!header) return std::nullopt;
  const std::optional<Eigen::Isometry3d> T_map_base = read_pose(reader);
  std::array<double, 36> covariance;
  for (double& value : covariance) value = reader.number<double>();
  if (!reader.ok() || !T_map_base) return std::nullopt;
  const double position = std::max(covariance[kVarianceX], covariance[kVarianceY]);
  return HintMessage{{header->stamp_s,
                      {projected(*T_map_base), sigma_of(position, kRvizSigma_m),
                       sigma_of(covariance[kVarianceHeading], kRvizSigma_rad)}},
                     header->frame};
}

std::optional<double> decode_clock(Bytes message, Wire wire) {
  WireReader reader(message, wire);
  return read_stamp(reader);
}

std::optional<std::vector<Transform>> decode_transforms(Bytes message, Wire wire, Defects* left_out) {
  WireReader reader(message, wire);
  constexpr std::size_t kLeastBytes = 72;  // stamp, two empty names, seven numbers
  std::vector<Transform> transforms;
  for (std::size_t left = reader.length(kLeastBytes); left > 0; --left) {
    const std::optional<MessageHeader> header = read_header(reader);
    if (!header) return std::nullopt;
    Transform transform{header->stamp_s, header->frame, reader.text()};
    const std::optional<Eigen::Isometry3d> T_parent_child = read_pose(reader);
    if (!reader.ok()) return std::nullopt;
    if (T_parent_child) {
      transform.T_parent_child = *T_parent_child;
      transforms.push_back(std::move(transform));
    } else if (left_out != nullptr) {
      ++(*left_out)["transform from " + transform.parent + " to " + transform.child + " that is no pose"];
    }
  }
  if (!reader.ok()) return std::nullopt;
  return transforms;
}

bool has_type(const Topic& topic, const std::string& type) {
  const std::size_t slash = type.find('/');
  const bool is_named = topic.type == type || topic.type == type.substr(0, slash) + "/msg" + type.substr(slash);
  return topic.wire != Wire::other && is_named;
}

bool has_scans(const Topic& topic) { return has_type(topic, "sensor_msgs/LaserScan"); }
bool has_clouds(const Topic& topic) { return has_type(topic, "sensor_msgs/PointCloud2"); }
bool has_odometry(const Topic& topic) { return has_type(topic, "nav_msgs/Odometry"); }
bool has_hints(const Topic& topic) { return has_type(topic, "geometry_msgs/PoseWithCovarianceStamped"); }
bool has_transforms(const Topic& topic, bool are_static) {
  const bool has_them = has_type(topic, "tf2_msgs/TFMessage") || has_type(topic, "tf/tfMessage");
  return has_them && topic.name.ends_with("tf_static") == are_static;
}

}  // namespace opal::recording
