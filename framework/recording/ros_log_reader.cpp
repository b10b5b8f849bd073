#include "recording/ros_log_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace opal::recording {
namespace {

// A transform that stands still for so long, from the start of a recording, is taken for a mount.
constexpr double kMountWindowS = 5;

// A driver without a clock leaves its stamps at zero.
double stamp_or_recorded(double stamp_s, double recorded_s) { return stamp_s == 0 ? recorded_s : stamp_s; }

double seconds(std::int64_t nanoseconds) { return kSecondsPerNanosecond * static_cast<double>(nanoseconds); }

void add_all(Defects& all, const Defects& more) {
  for (const auto& [cause, times] : more) all[cause] += times;
}

}  // namespace

RosLogReader::RosLogReader(Parts parts, ChosenTopics chosen)
    : parts_(std::move(parts)), topics_(std::move(chosen.topics)) {
  if (!chosen.remark.empty()) ++defects_[chosen.remark];
  for (const auto& part : parts_) {
    add_all(defects_, part->defects());
    spans_.push_back(span_of(*part));
  }
  reached_s_ = spans_.front().begin_s;
  if (topics_.odometry.empty()) {
    const OdometryLink link = find_odometry_link(parts_, topics_);
    transforms_are_odometry_ = link.exists;
    if (link.exists) topics_.base_frame = link.base_frame;
    if (!link.exists) ++defects_[link.complaint];
  }
  find_mount();
}

SeenTransforms RosLogReader::read_transforms(bool with_moving) {
  SeenTransforms seen;
  const double until_s = spans_.front().begin_s + kMountWindowS;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Recording& part = *parts_[i];
    if (with_moving && spans_[i].begin_s > until_s) break;
    const auto walk =
        part.walk(topics_where(part, [&](const Topic& topic) { return has_transforms(topic, !with_moving); }));
    while (const auto message = walk->next()) {
      if (with_moving && seconds(message->recorded_ns) > until_s) break;
      const Topic& topic = part.topics()[message->topic];
      const auto transforms = decode_transforms(message->data, topic.wire);
      // Moving transforms are counted while they are played, if they are.
      if (!transforms && !with_moving) ++defects_["damaged TFMessage"];
      for (const Transform& transform : transforms.value_or(std::vector<Transform>{}))
        if (!with_moving || !is_odometry(transform, topics_)) seen.add(transform, topic.name, !with_moving);
    }
  }
  return seen;
}

template <class Wanted, class Decoder>
std::optional<Wanted> RosLogReader::first_of(const std::string& topic, Decoder decoder) const {
  for (const auto& part : parts_) {
    const auto walk = part->walk(topics_where(*part, is_named(topic)));
    while (const auto message = walk->next())
      if (std::optional<Wanted> decoded = decoder(message->data, part->topics()[message->topic].wire)) return decoded;
  }
  return std::nullopt;
}

std::string RosLogReader::base_frame_of(const FixedFrames& frames, const std::string& laser_frame) const {
  if (transforms_are_odometry_) return topics_.base_frame;
  const auto odometry = first_of<OdometryMessage>(topics_.odometry, decode_odometry);
  return odometry ? odometry->base_frame : frames.root_of(laser_frame);
}

void RosLogReader::find_mount() {
  const auto laser = first_of<LaserScanMessage>(topics_.scan, decode_laser_scan);
  if (!laser) return;
  const std::string& frame = laser->scan.frame;
  FixedFrames frames = read_transforms(false).fixed_frames();
  const std::string base = base_frame_of(frames, frame);
  std::optional<Eigen::Isometry3d> T_base_laser = frames.pose(base, frame);
  const bool has_base = transforms_are_odometry_ || !topics_.odometry.empty();
  if (!T_base_laser && has_base) {
    const SeenTransforms moving = read_transforms(true);
    for (const auto& [link, seen] : moving.by_link())
      if (!seen.moves) frames.add_unless_known(seen.last);
    T_base_laser = frames.pose(base, frame);
  }
  const bool stands_alone = !has_base && base == frame;  // nothing carries it
  if (!T_base_laser || stands_alone) {
    ++defects_["no static transform from " + (stands_alone ? "anything" : base) + " to " + frame];
    return;
  }
  const double upright = T_base_laser->linear()(2, 2);
  if (std::abs(upright) < kUprightCosine) ++defects_["laser that is tilted"];
  upside_down_ = upright < 0;
  mount_ = MountRecord{base, frame, projected(*T_base_laser)};
}

/// Seen from above, the beams of a laser that hangs upside down turn the other way.
void RosLogReader::turn_upright(RawScan& scan) const {
  if (!upside_down_) return;
  scan.angle_min_rad = -*scan.angle_min_rad;
  scan.angle_increment_rad = -*scan.angle_increment_rad;
}

std::optional<Message> RosLogReader::next_message() {
  for (; part_ < parts_.size(); ++part_) {
    const Recording& part = *parts_[part_];
    if (!walk_)
      walk_ = part.walk(topics_where(part, [this](const Topic& topic) {
        return topic.name == topics_.scan || (!topics_.odometry.empty() && topic.name == topics_.odometry) ||
               (transforms_are_odometry_ && has_transforms(topic, false));
      }));
    if (auto message = walk_->next()) return message;
    add_all(defects_, walk_->defects());
    walk_.reset();
  }
  return std::nullopt;
}

RosLogReader::Decoded RosLogReader::odometry_of(const Message& message, Wire wire, double recorded_s) const {
  const auto decoded = decode_transforms(message.data, wire);
  if (!decoded) return {std::nullopt, true};
  const auto found = std::find_if(decoded->begin(), decoded->end(),
                                  [&](const Transform& transform) { return is_odometry(transform, topics_); });
  if (found == decoded->end()) return {};
  return {OdometryRecord{stamp_or_recorded(found->stamp_s, recorded_s), projected(found->T_parent_child)}};
}

RosLogReader::Decoded RosLogReader::decode(const Message& message, const Topic& topic, double recorded_s) const {
  if (topic.name == topics_.scan) {
    std::optional<LaserScanMessage> laser = decode_laser_scan(message.data, topic.wire);
    if (!laser) return {std::nullopt, true};
    laser->scan.stamp_s = stamp_or_recorded(laser->scan.stamp_s, recorded_s);
    turn_upright(laser->scan);
    return {std::move(laser->scan)};
  }
  if (topic.name != topics_.odometry) return odometry_of(message, topic.wire, recorded_s);
  std::optional<OdometryMessage> odometry = decode_odometry(message.data, topic.wire);
  if (!odometry) return {std::nullopt, true};
  odometry->odometry.stamp_s = stamp_or_recorded(odometry->odometry.stamp_s, recorded_s);
  return {odometry->odometry};
}

std::optional<LogRecord> RosLogReader::next() {
  if (mount_) return std::exchange(mount_, std::nullopt);
  while (const auto message = next_message()) {
    reached_s_ = seconds(message->recorded_ns);
    const Topic& topic = parts_[part_]->topics()[message->topic];
    Decoded decoded = decode(*message, topic, reached_s_);
    if (decoded.record) return std::move(decoded.record);
    if (!decoded.damaged) continue;
    ++defects_[topic.name == topics_.scan       ? "damaged LaserScan message"
               : topic.name == topics_.odometry ? "damaged Odometry message"
                                                : "damaged TFMessage"];
  }
  return std::nullopt;
}

std::map<std::string, int> RosLogReader::defects() const {
  Defects all = defects_;
  if (walk_) add_all(all, walk_->defects());
  return all;
}

double RosLogReader::progress() const {
  if (part_ == parts_.size()) return 1;
  const double whole_s = spans_.back().end_s - spans_.front().begin_s;
  return whole_s > 0 ? std::clamp((reached_s_ - spans_.front().begin_s) / whole_s, 0.0, 1.0) : 0;
}

}  // namespace opal::recording
