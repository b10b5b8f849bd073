#include "bag_reader.hpp"

#include <algorithm>
#include <cmath>

namespace opal::ros2_bag {
namespace {

// cos 10 deg: a laser that is tilted more sees floor and ceiling within a few metres.
constexpr double kUprightCosine = 0.985;

std::vector<std::int64_t> ids_of(const BagFile& file, const std::vector<std::string>& names) {
  std::vector<std::int64_t> ids;
  for (const Topic& topic : file.topics())
    if (std::find(names.begin(), names.end(), topic.name) != names.end()) ids.push_back(topic.id);
  return ids;
}

const std::string& name_of(const BagFile& file, std::int64_t id) {
  static const std::string kNone;
  for (const Topic& topic : file.topics())
    if (topic.id == id) return topic.name;
  return kNone;
}

std::vector<std::string> static_transform_topics(const BagFile& file) {
  std::vector<std::string> names;
  for (const Topic& topic : file.topics())
    if (topic.type == "tf2_msgs/msg/TFMessage" && topic.name.ends_with("tf_static")) names.push_back(topic.name);
  return names;
}

}  // namespace

BagReader::BagReader(std::vector<BagFile> files, TopicChoice topics)
    : files_(std::move(files)), topics_(std::move(topics)), reached_s_(files_.front().begin_s()) {
  find_mount();
}

StaticFrames BagReader::read_static_frames() {
  StaticFrames frames;
  for (const BagFile& file : files_) {
    BagFile::Messages messages = file.messages(ids_of(file, static_transform_topics(file)));
    while (messages.next()) {
      const auto transforms = decode_transforms(messages.data());
      if (!transforms) ++defects_["damaged TFMessage"];
      if (transforms)
        for (const Transform& transform : *transforms) frames.add(transform);
    }
  }
  return frames;
}

template <class Message, class Decode>
std::optional<Message> BagReader::first_of(const std::string& topic, Decode decode) const {
  for (const BagFile& file : files_) {
    BagFile::Messages messages = file.messages(ids_of(file, {topic}));
    while (messages.next())
      if (std::optional<Message> message = decode(messages.data())) return message;
  }
  return std::nullopt;
}

void BagReader::find_mount() {
  const auto scan = first_of<RawScan>(topics_.scan, decode_laser_scan);
  if (!scan) return;
  const StaticFrames frames = read_static_frames();
  const auto odometry = first_of<OdometryMessage>(topics_.odometry, decode_odometry);
  const std::string base = odometry ? odometry->base_frame : frames.root_of(scan->frame);
  const std::optional<Eigen::Isometry3d> T_base_laser = frames.pose(base, scan->frame);
  const bool stands_alone = !odometry && base == scan->frame;  // nothing carries it
  if (!T_base_laser || stands_alone) {
    ++defects_["no static transform from " + (stands_alone ? "anything" : base) + " to " + scan->frame];
    return;
  }
  const double upright = T_base_laser->linear()(2, 2);
  if (std::abs(upright) < kUprightCosine) ++defects_["laser that is tilted"];
  upside_down_ = upright < 0;
  mount_ = MountRecord{base, scan->frame, projected(*T_base_laser)};
}

/// Seen from above, the beams of a laser that hangs upside down turn the other way.
void BagReader::turn_upright(RawScan& scan) const {
  if (!upside_down_) return;
  scan.angle_min_rad = -*scan.angle_min_rad;
  scan.angle_increment_rad = -*scan.angle_increment_rad;
}

bool BagReader::next_message() {
  while (file_ < files_.size()) {
    const BagFile& file = files_[file_];
    if (!messages_) messages_ = file.messages(ids_of(file, {topics_.scan, topics_.odometry}));
    if (messages_->next()) return true;
    if (messages_->damaged()) ++defects_["damaged file"];
    messages_.reset();
    ++file_;
  }
  return false;
}

std::optional<LogRecord> BagReader::decode_current() {
  const double recorded_s = messages_->recorded_s();
  reached_s_ = recorded_s;
  // A driver without a clock leaves its stamps at zero.
  const auto stamp_or_recorded = [recorded_s](double stamp_s) { return stamp_s == 0 ? recorded_s : stamp_s; };
  if (name_of(files_[file_], messages_->topic()) == topics_.scan) {
    std::optional<RawScan> scan = decode_laser_scan(messages_->data());
    if (!scan) return std::nullopt;
    scan->stamp_s = stamp_or_recorded(scan->stamp_s);
    turn_upright(*scan);
    return std::move(*scan);
  }
  std::optional<OdometryMessage> message = decode_odometry(messages_->data());
  if (!message) return std::nullopt;
  message->odometry.stamp_s = stamp_or_recorded(message->odometry.stamp_s);
  return message->odometry;
}

std::optional<LogRecord> BagReader::next() {
  if (mount_) {
    const MountRecord mount = std::move(*mount_);
    mount_.reset();
    return mount;
  }
  while (next_message()) {
    if (std::optional<LogRecord> record = decode_current()) return record;
    const bool is_scan = name_of(files_[file_], messages_->topic()) == topics_.scan;
    ++defects_[is_scan ? "damaged LaserScan message" : "damaged Odometry message"];
  }
  return std::nullopt;
}

double BagReader::progress() const {
  if (file_ == files_.size()) return 1;
  const double whole_s = files_.back().end_s() - files_.front().begin_s();
  return whole_s > 0 ? std::clamp((reached_s_ - files_.front().begin_s()) / whole_s, 0.0, 1.0) : 0;
}

}  // namespace opal::ros2_bag
