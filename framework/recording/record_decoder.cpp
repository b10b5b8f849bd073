#include "recording/record_decoder.hpp"

#include "common/phrases.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace opal::recording {
namespace {

// cos 10 deg: a laser that is tilted more sees floor and ceiling within a few metres.
constexpr double kUprightCosine = 0.985;

// A driver without a clock leaves its stamps at zero.
double stamp_or_received(double stamp_s, double received_s) { return stamp_s == 0 ? received_s : stamp_s; }

/// @param chosen  name of a topic; empty: none.
bool is_topic(const std::string& chosen, const Topic& topic) { return !chosen.empty() && topic.name == chosen; }

/// Seen from above, the beams of a laser that hangs upside down turn the other way.
void turn_beams(RawScan& scan) {
  scan.angle_min_rad = -*scan.angle_min_rad;
  scan.angle_increment_rad = -*scan.angle_increment_rad;
}

}  // namespace

double seconds_of(std::int64_t nanoseconds) { return kSecondsPerNanosecond * static_cast<double>(nanoseconds); }

std::optional<LaserMount> find_laser_mount(const FixedFrames& frames, const std::string& base,
                                           const std::string& laser_frame) {
  const std::optional<Eigen::Isometry3d> T_base_laser = frames.pose(base, laser_frame);
  if (!T_base_laser) return std::nullopt;
  const double upright = T_base_laser->linear()(2, 2);
  return LaserMount{
      {base, laser_frame, projected(*T_base_laser)}, *T_base_laser, upright < 0, std::abs(upright) < kUprightCosine};
}

std::optional<std::string> frame_of(const Topic& topic, Bytes data) {
  if (has_clouds(topic)) {
    const DecodedPointCloud decoded = decode_point_cloud(data, topic.wire);
    return decoded.cloud ? std::optional(decoded.cloud->frame) : std::nullopt;
  }
  const std::optional<LaserScanMessage> laser = decode_laser_scan(data, topic.wire);
  return laser ? std::optional(laser->scan.frame) : std::nullopt;
}

RecordDecoder::RecordDecoder(TopicChoice topics) : topics_(std::move(topics)) {
  for (const auto& [topic, laser] : topics_.slices) slicers_.emplace(topic, CloudSlicer(laser));
}

void RecordDecoder::take_odometry_from_transforms(const std::string& base_frame) {
  transforms_are_odometry_ = true;
  topics_.odometry.clear();
  topics_.base_frame = base_frame;
}

void RecordDecoder::add_mount(const LaserMount& mount) {
  mounts_[mount.record.child] = mount;
  if (mount.is_tilted) tilted_.insert(mount.record.child);
}

bool RecordDecoder::reads(const Topic& topic) const {
  return reads_scans_of(topics_, topic.name) || is_topic(topics_.odometry, topic) || is_topic(topics_.hints, topic) ||
         is_topic(topics_.forget, topic) || (transforms_are_odometry_ && has_transforms(topic, false));
}

std::optional<LogRecord> RecordDecoder::decode(const Topic& topic, Bytes data, double received_s) {
  if (!reads(topic)) return std::nullopt;
  if (topics_.slices.contains(topic.name)) return slice_of(topic, data, received_s);
  if (reads_scans_of(topics_, topic.name)) return scan_of(data, topic.wire, received_s);
  if (is_topic(topics_.odometry, topic)) return pose_of(data, topic.wire, received_s);
  if (is_topic(topics_.hints, topic)) return hint_of(data, topic.wire, received_s);
  if (is_topic(topics_.forget, topic)) return ForgetRecord{};
  return transform_of(data, topic.wire, received_s);
}

std::optional<LogRecord> RecordDecoder::scan_of(Bytes data, Wire wire, double received_s) {
  std::optional<LaserScanMessage> laser = decode_laser_scan(data, wire);
  if (!laser) {
    ++defects_["damaged LaserScan message"];
    return std::nullopt;
  }
  laser->scan.stamp_s = stamp_or_received(laser->scan.stamp_s, received_s);
  const auto mount = mounts_.find(laser->scan.frame);
  if (mount != mounts_.end() && mount->second.upside_down) turn_beams(laser->scan);
  if (tilted_.erase(laser->scan.frame) > 0) ++defects_["laser that is tilted"];
  return std::move(laser->scan);
}

std::optional<LogRecord> RecordDecoder::slice_of(const Topic& topic, Bytes data, double received_s) {
  DecodedPointCloud decoded = decode_point_cloud(data, has_clouds(topic) ? topic.wire : Wire::other);
  if (!decoded.cloud) {
    ++defects_[decoded.complaint];
    return std::nullopt;
  }
  decoded.cloud->stamp_s = stamp_or_received(decoded.cloud->stamp_s, received_s);
  CloudSlicer& slicer = slicers_.at(topic.name);
  const auto mount = mounts_.find(decoded.cloud->frame);
  if (mount != mounts_.end()) slicer.set_mount(mount->second.T_base_laser);
  return slicer.scan_of(*decoded.cloud);
}

std::optional<LogRecord> RecordDecoder::pose_of(Bytes data, Wire wire, double received_s) {
  std::optional<OdometryMessage> odometry = decode_odometry(data, wire);
  if (!odometry) {
    ++defects_["damaged Odometry message"];
    return std::nullopt;
  }
  odometry->odometry.stamp_s = stamp_or_received(odometry->odometry.stamp_s, received_s);
  return odometry->odometry;
}

std::optional<LogRecord> RecordDecoder::hint_of(Bytes data, Wire wire, double received_s) {
  std::optional<HintMessage> said = decode_hint(data, wire);
  if (!said) {
    ++defects_["hint that is damaged, or no pose"];
    return std::nullopt;
  }
  if (const std::string frame = without_slash(said->frame); frame != topics_.map_frame) {
    ++defects_["hint in frame " + in_quotes(frame) + ", expected " + in_quotes(topics_.map_frame)];
    return std::nullopt;
  }
  said->hint.stamp_s = stamp_or_received(said->hint.stamp_s, received_s);
  return said->hint;
}

std::optional<LogRecord> RecordDecoder::transform_of(Bytes data, Wire wire, double received_s) {
  const auto decoded = decode_transforms(data, wire, &defects_);
  if (!decoded) {
    ++defects_["damaged TFMessage"];
    return std::nullopt;
  }
  const auto found = std::find_if(decoded->begin(), decoded->end(),
                                  [&](const Transform& transform) { return is_odometry(transform, topics_); });
  if (found == decoded->end()) return std::nullopt;
  return OdometryRecord{stamp_or_received(found->stamp_s, received_s), projected(found->T_parent_child)};
}

}  // namespace opal::recording
