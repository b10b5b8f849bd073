#include "bag_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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

std::vector<std::string> transform_topics(const BagFile& file, bool are_static) {
  std::vector<std::string> names;
  for (const Topic& topic : file.topics())
    if (topic.type == "tf2_msgs/msg/TFMessage" && topic.name.ends_with("tf_static") == are_static)
      names.push_back(topic.name);
  return names;
}

/// "odom to base_footprint, map to odom"
std::string listed(const std::set<std::pair<std::string, std::string>>& links) {
  std::string text;
  for (const auto& [parent, child] : links) text += (text.empty() ? "" : ", ") + parent + " to " + child;
  return text;
}

}  // namespace

BagReader::BagReader(std::vector<BagFile> files, TopicChoice topics)
    : files_(std::move(files)), topics_(std::move(topics)), reached_s_(files_.front().begin_s()) {
  topics_.odom_frame = without_slash(topics_.odom_frame);
  topics_.base_frame = without_slash(topics_.base_frame);
  if (topics_.odometry.empty()) find_odometry_transform();
  find_mount();
}

bool BagReader::is_odometry(const Transform& transform) const {
  return without_slash(transform.parent) == topics_.odom_frame &&
         (topics_.base_frame.empty() || without_slash(transform.child) == topics_.base_frame);
}

void BagReader::find_odometry_transform() {
  std::set<std::pair<std::string, std::string>> others;
  for (const BagFile& file : files_) {
    BagFile::Messages messages = file.messages(ids_of(file, transform_topics(file, false)));
    while (messages.next())
      for (const Transform& transform : decode_transforms(messages.data()).value_or(std::vector<Transform>{})) {
        transforms_are_odometry_ = is_odometry(transform);
        if (transforms_are_odometry_) topics_.base_frame = without_slash(transform.child);
        if (transforms_are_odometry_) return;
        others.emplace(without_slash(transform.parent), without_slash(transform.child));
      }
  }
  const std::string frames = topics_.odom_frame + (topics_.base_frame.empty() ? "" : " to " + topics_.base_frame);
  ++defects_["no odometry: no topic has it, and no transform from " + frames +
             (others.empty() ? "" : "; the options odom_frame and base_frame may name one of " + listed(others))];
}

StaticFrames BagReader::read_static_frames() {
  StaticFrames frames;
  for (const BagFile& file : files_) {
    BagFile::Messages messages = file.messages(ids_of(file, transform_topics(file, true)));
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
  const std::string base = odometry                   ? odometry->base_frame
                           : transforms_are_odometry_ ? topics_.base_frame
                                                      : frames.root_of(scan->frame);
  const std::optional<Eigen::Isometry3d> T_base_laser = frames.pose(base, scan->frame);
  const bool stands_alone = !odometry && !transforms_are_odometry_ && base == scan->frame;  // nothing carries it
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
    if (!messages_) {
      std::vector<std::string> names{topics_.scan, topics_.odometry};
      if (transforms_are_odometry_)
        for (const std::string& name : transform_topics(file, false)) names.push_back(name);
      messages_ = file.messages(ids_of(file, names));
    }
    if (messages_->next()) return true;
    if (messages_->damaged()) ++defects_["damaged file"];
    messages_.reset();
    ++file_;
  }
  return false;
}

namespace {

// A driver without a clock leaves its stamps at zero.
double stamp_or_recorded(double stamp_s, double recorded_s) { return stamp_s == 0 ? recorded_s : stamp_s; }

}  // namespace

BagReader::Decoded BagReader::odometry_of(Bytes transforms, double recorded_s) const {
  const auto decoded = decode_transforms(transforms);
  if (!decoded) return {std::nullopt, true};
  const auto found = std::find_if(decoded->begin(), decoded->end(),
                                  [&](const Transform& transform) { return is_odometry(transform); });
  if (found == decoded->end()) return {};
  return {OdometryRecord{stamp_or_recorded(found->stamp_s, recorded_s), projected(found->T_parent_child)}};
}

BagReader::Decoded BagReader::decode_current() {
  const double recorded_s = messages_->recorded_s();
  reached_s_ = recorded_s;
  const std::string& topic = name_of(files_[file_], messages_->topic());
  if (topic == topics_.scan) {
    std::optional<RawScan> scan = decode_laser_scan(messages_->data());
    if (!scan) return {std::nullopt, true};
    scan->stamp_s = stamp_or_recorded(scan->stamp_s, recorded_s);
    turn_upright(*scan);
    return {std::move(*scan)};
  }
  if (topic != topics_.odometry) return odometry_of(messages_->data(), recorded_s);
  std::optional<OdometryMessage> message = decode_odometry(messages_->data());
  if (!message) return {std::nullopt, true};
  message->odometry.stamp_s = stamp_or_recorded(message->odometry.stamp_s, recorded_s);
  return {message->odometry};
}

std::optional<LogRecord> BagReader::next() {
  if (mount_) {
    const MountRecord mount = std::move(*mount_);
    mount_.reset();
    return mount;
  }
  while (next_message()) {
    Decoded decoded = decode_current();
    if (decoded.record) return std::move(decoded.record);
    if (!decoded.damaged) continue;
    const std::string& topic = name_of(files_[file_], messages_->topic());
    ++defects_[topic == topics_.scan       ? "damaged LaserScan message"
               : topic == topics_.odometry ? "damaged Odometry message"
                                           : "damaged TFMessage"];
  }
  return std::nullopt;
}

double BagReader::progress() const {
  if (file_ == files_.size()) return 1;
  const double whole_s = files_.back().end_s() - files_.front().begin_s();
  return whole_s > 0 ? std::clamp((reached_s_ - files_.front().begin_s()) / whole_s, 0.0, 1.0) : 0;
}

}  // namespace opal::ros2_bag
