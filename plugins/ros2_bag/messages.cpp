#include "messages.hpp"

#include "cdr_reader.hpp"

#include <cmath>
#include <limits>

namespace opal::ros2_bag {
namespace {

constexpr std::size_t kMostReadings = 100'000;
constexpr double kFarthestM = 1e7;

struct Header {
  double stamp_s = 0;
  std::string frame;
};

std::optional<Header> read_header(CdrReader& cdr) {
  const auto seconds = cdr.number<std::int32_t>();
  const auto nanoseconds = cdr.number<std::uint32_t>();
  Header header{seconds + 1e-9 * nanoseconds, cdr.text()};
  if (!cdr.ok() || nanoseconds >= 1'000'000'000u) return std::nullopt;
  return header;
}

/// Position and quaternion (x y z w), as in geometry_msgs/msg/Pose and Transform.
std::optional<Eigen::Isometry3d> read_pose(CdrReader& cdr) {
  double values[7];
  for (double& value : values) value = cdr.number<double>();
  const Eigen::Vector3d position(values[0], values[1], values[2]);
  const Eigen::Quaterniond turn(values[6], values[3], values[4], values[5]);
  const double norm = turn.norm();
  const bool usable = position.allFinite() && position.cwiseAbs().maxCoeff() < kFarthestM && norm > 0.5 && norm < 2;
  if (!cdr.ok() || !usable) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = turn.normalized().toRotationMatrix();
  pose.translation() = position;
  return pose;
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

std::optional<RawScan> decode_laser_scan(Bytes message) {
  CdrReader cdr(message);
  const std::optional<Header> header = read_header(cdr);
  if (!header) return std::nullopt;
  RawScan scan;
  scan.stamp_s = header->stamp_s;
  scan.frame = header->frame;
  scan.angle_min_rad = cdr.number<float>();
  cdr.skip_numbers(1, sizeof(float));  // angle_max: follows from the number of readings
  scan.angle_increment_rad = cdr.number<float>();
  cdr.skip_numbers(2, sizeof(float));  // time_increment, scan_time
  const auto range_min_m = cdr.number<float>();
  const auto range_max_m = cdr.number<float>();
  scan.ranges_m.resize(std::min(cdr.length(sizeof(float)), kMostReadings + 1));
  for (float& range_m : scan.ranges_m) range_m = cdr.number<float>();
  const bool has_angles =
      std::abs(*scan.angle_min_rad) < 10 && std::abs(*scan.angle_increment_rad) < 10 && *scan.angle_increment_rad != 0;
  if (!cdr.ok() || !has_angles || scan.ranges_m.size() > kMostReadings) return std::nullopt;
  mark_out_of_range(scan.ranges_m, range_min_m, range_max_m);
  return scan;
}

std::optional<OdometryMessage> decode_odometry(Bytes message) {
  CdrReader cdr(message);
  const std::optional<Header> header = read_header(cdr);
  if (!header) return std::nullopt;
  std::string base_frame = cdr.text();
  const std::optional<Eigen::Isometry3d> T_odom_base = read_pose(cdr);
  if (!T_odom_base) return std::nullopt;
  return OdometryMessage{{header->stamp_s, projected(*T_odom_base)}, std::move(base_frame)};
}

std::optional<std::vector<Transform>> decode_transforms(Bytes message) {
  CdrReader cdr(message);
  constexpr std::size_t kLeastBytes = 72;  // stamp, two empty names, seven numbers
  std::vector<Transform> transforms(cdr.length(kLeastBytes));
  for (Transform& transform : transforms) {
    const std::optional<Header> header = read_header(cdr);
    if (!header) return std::nullopt;
    transform.stamp_s = header->stamp_s;
    transform.parent = header->frame;
    transform.child = cdr.text();
    const std::optional<Eigen::Isometry3d> T_parent_child = read_pose(cdr);
    if (!T_parent_child) return std::nullopt;
    transform.T_parent_child = *T_parent_child;
  }
  if (!cdr.ok()) return std::nullopt;
  return transforms;
}

}  // namespace opal::ros2_bag
