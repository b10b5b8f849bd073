// What the robot of Fast DDS says: a log of CARMEN as messages of ROS 2.
#pragma once

#include "ros2_messagesPubSubTypes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <istream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace said {

// Recordings start at 0, which ROS takes for "never set".
constexpr long kEpochNs = 1'700'000'000L * 1'000'000'000L;

inline builtin_interfaces::msg::dds_::Time_ time_at(double log_s) {
  const long ns = kEpochNs + std::lround(log_s * 1e6) * 1000;
  builtin_interfaces::msg::dds_::Time_ time;
  time.sec(static_cast<int>(ns / 1'000'000'000L));
  time.nanosec(static_cast<unsigned>(ns % 1'000'000'000L));
  return time;
}

/// One of the robot's lasers.
struct Laser {
  std::string message, frame, topic;
  bool sends_clouds = false;
  double angle_min = 0, increment = 0, range_max = 0, sweep = 0, x = 0, y = 0, heading = 0;
};

inline Laser laser_of(std::string words) {
  std::replace(words.begin(), words.end(), ',', ' ');
  std::istringstream in(words);
  Laser laser;
  std::string kind;
  in >> laser.message >> laser.frame >> laser.topic >> kind >> laser.angle_min >> laser.increment >> laser.range_max >>
      laser.sweep >> laser.x >> laser.y >> laser.heading;
  laser.sends_clouds = kind == "cloud";
  if (!in) throw std::runtime_error("no laser: " + words);
  return laser;
}

struct Record {
  std::string kind;  // "ODOM", the message of a laser, or what a person says: "HINT", "FORGET"
  double stamp_s = 0, x = 0, y = 0, heading = 0;
  std::vector<float> ranges;

  bool is_scan() const { return kind == "FLASER" || kind == "RLASER"; }
  bool is_said() const { return kind == "HINT" || kind == "FORGET"; }
};

/// ODOM x y heading tv rv accel stamp host stamp; FLASER n ranges... x y heading x y heading stamp host stamp; and for
/// tests: HINT x y heading stamp; FORGET x y heading stamp
inline std::vector<Record> read_log(std::istream& log) {
  std::vector<Record> records;
  for (std::string line; std::getline(log, line);) {
    std::istringstream words(line);
    std::string skipped;
    Record record;
    words >> record.kind;
    if (record.kind != "ODOM" && !record.is_scan() && !record.is_said()) continue;
    std::size_t beams = 0;
    if (record.is_scan()) words >> beams;
    record.ranges.resize(beams);
    for (float& range : record.ranges) words >> range;
    for (int i = 0; record.is_scan() && i < 3; ++i) words >> skipped;
    words >> record.x >> record.y >> record.heading;
    for (int i = 0; record.kind == "ODOM" && i < 3; ++i) words >> skipped;
    words >> record.stamp_s;
    records.push_back(record);
  }
  return records;
}

inline geometry_msgs::msg::dds_::TransformStamped_ link(double stamp_s, const std::string& parent,
                                                        const std::string& child, double x, double y, double heading) {
  geometry_msgs::msg::dds_::TransformStamped_ transform;
  transform.header().stamp(time_at(stamp_s));
  transform.header().frame_id(parent);
  transform.child_frame_id(child);
  transform.transform().translation().x(x);
  transform.transform().translation().y(y);
  transform.transform().rotation().z(std::sin(heading / 2));
  transform.transform().rotation().w(std::cos(heading / 2));
  return transform;
}

inline geometry_msgs::msg::dds_::PoseWithCovarianceStamped_ hint_of(const Record& record) {
  geometry_msgs::msg::dds_::PoseWithCovarianceStamped_ hint;
  hint.header().stamp(time_at(record.stamp_s));
  hint.header().frame_id("map");
  hint.pose().pose().position().x(record.x);
  hint.pose().pose().position().y(record.y);
  hint.pose().pose().orientation().z(std::sin(record.heading / 2));
  hint.pose().pose().orientation().w(std::cos(record.heading / 2));
  return hint;
}

/// A planar laser lies in the floor's plane; a lidar is 1 m above it, and looks down by 0.1 rad.
constexpr double kLidarHeight = 1, kLidarPitch = 0.1;

inline geometry_msgs::msg::dds_::TransformStamped_ mount_of(const Laser& laser) {
  auto mount = link(0, "base_link", laser.frame, laser.x, laser.y, laser.heading);
  if (!laser.sends_clouds) return mount;
  mount.transform().translation().z(kLidarHeight);
  auto& turn = mount.transform().rotation();  // about z, then about y
  turn.w(std::cos(laser.heading / 2) * std::cos(kLidarPitch / 2));
  turn.x(-std::sin(laser.heading / 2) * std::sin(kLidarPitch / 2));
  turn.y(std::cos(laser.heading / 2) * std::sin(kLidarPitch / 2));
  turn.z(std::sin(laser.heading / 2) * std::cos(kLidarPitch / 2));
  return mount;
}

inline sensor_msgs::msg::dds_::LaserScan_ scan_of(const Record& record, const Laser& laser) {
  sensor_msgs::msg::dds_::LaserScan_ scan;
  const double last = static_cast<double>(record.ranges.size()) - 1;
  scan.header().stamp(time_at(record.stamp_s));
  scan.header().frame_id(laser.frame);
  scan.angle_min(static_cast<float>(laser.angle_min));
  scan.angle_increment(static_cast<float>(laser.increment));
  scan.angle_max(static_cast<float>(laser.angle_min + last * laser.increment));
  scan.time_increment(static_cast<float>(laser.sweep / last));
  scan.range_min(0.0f);
  scan.range_max(static_cast<float>(laser.range_max));
  scan.ranges(record.ranges);
  return scan;
}

/// The walls at two heights, the floor before them, a lamp, and NaN where there was nothing: in rows.
inline sensor_msgs::msg::dds_::PointCloud2_ cloud_of(const Record& record, const Laser& laser) {
  constexpr std::pair<double, double> kThings[] = {{1, 0.5}, {1, 1.4}, {0.7, 0}, {0.5, 2.2}};  // share of range, height
  std::vector<float> numbers;
  for (const auto& [share, height] : kThings)
    for (std::size_t k = 0; k < record.ranges.size(); ++k) {
      const double bearing = laser.angle_min + static_cast<double>(k) * laser.increment;
      const double range = record.ranges[k] < laser.range_max ? record.ranges[k] * share : std::nan("");
      const double x = range * std::cos(bearing), y = range * std::sin(bearing), z = height - kLidarHeight;
      numbers.push_back(static_cast<float>(std::cos(kLidarPitch) * x - std::sin(kLidarPitch) * z));
      numbers.push_back(static_cast<float>(y));
      numbers.push_back(static_cast<float>(std::sin(kLidarPitch) * x + std::cos(kLidarPitch) * z));
      numbers.push_back(1);  // intensity
    }
  sensor_msgs::msg::dds_::PointCloud2_ cloud;
  cloud.header().stamp(time_at(record.stamp_s));
  cloud.header().frame_id(laser.frame);
  cloud.height(std::size(kThings));
  cloud.width(static_cast<unsigned>(record.ranges.size()));
  unsigned offset = 0;
  for (const char* name : {"x", "y", "z", "intensity"}) {
    sensor_msgs::msg::dds_::PointField_ field;
    field.name(name);
    field.offset(offset);
    field.datatype(7);
    field.count(1);
    cloud.fields().push_back(field);
    offset += 4;
  }
  cloud.is_bigendian(false);
  cloud.point_step(offset);
  cloud.row_step(offset * cloud.width());
  cloud.data().resize(numbers.size() * sizeof(float));
  std::memcpy(cloud.data().data(), numbers.data(), cloud.data().size());
  cloud.is_dense(false);
  return cloud;
}

inline nav_msgs::msg::dds_::Odometry_ odometry_of(const Record& record) {
  nav_msgs::msg::dds_::Odometry_ pose;
  pose.header().stamp(time_at(record.stamp_s));
  pose.header().frame_id("odom");
  pose.child_frame_id("base_link");
  pose.pose().pose().position().x(record.x);
  pose.pose().pose().position().y(record.y);
  pose.pose().pose().orientation().z(std::sin(record.heading / 2));
  pose.pose().pose().orientation().w(std::cos(record.heading / 2));
  return pose;
}

}  // namespace said
