#include "recording/ros_stream.hpp"

#include "common/phrases.hpp"
#include "recording/ros_log_reader.hpp"

#include <algorithm>
#include <utility>

namespace opal::recording {
namespace {

// Ten minutes of a laser of 1,000 beams at 10 Hz with its odometry.
constexpr std::size_t kMostHeldBytes = 64 << 20;

}  // namespace

RosStream::RosStream(TopicChoice topics, double mount_patience_s)
    : decoder_(std::move(topics)),
      scan_topics_(scan_topics_of(decoder_.topics())),
      mount_patience_s_(mount_patience_s) {}

void RosStream::take_odometry_from_topic(const std::string& topic) {
  TopicChoice topics = decoder_.topics();
  topics.odometry = topic;
  decoder_ = RecordDecoder(std::move(topics));
  base_frame_.clear();
  odom_frame_.reset();
}

bool RosStream::take_odometry_from_transforms(const std::string& base_frame) {
  if (is_open_ && base_frame != base_frame_) return false;
  base_frame_ = base_frame;
  odom_frame_.reset();
  decoder_.take_odometry_from_transforms(base_frame);
  return true;
}

void RosStream::take(ReceivedMessage message) {
  newest_s_ = seconds_of(message.received_ns);
  if (!first_s_) first_s_ = newest_s_;
  const bool lacks_lasers = !is_open_ || admitted_.size() < scan_topics_.size();
  if (lacks_lasers) look_at(message);
  if (is_open_ && lacks_lasers) admit_late_lasers();
  held_bytes_ += message.data.size();
  held_.push_back(std::move(message));
  if (!is_open_) try_to_open();
  if (!is_open_) bound_memory();
}

void RosStream::look_at(const ReceivedMessage& message) {
  const Topic& topic = message.topic;
  if (reads_scans_of(decoder_.topics(), topic.name)) {
    if (laser_by_topic_.contains(topic.name)) return;
    if (const auto frame = frame_of(topic, message.bytes())) laser_by_topic_[topic.name] = {*frame, newest_s_};
  } else if (has_odometry(topic) && topic.name == decoder_.topics().odometry && !odom_frame_) {
    if (const auto odometry = decode_odometry(message.bytes(), topic.wire)) meet_odometry(*odometry);
  } else if (has_transforms(topic, true)) {
    look_at_transforms(message, true);
  } else if (has_transforms(topic, false)) {
    look_at_transforms(message, false);
  }
}

/// Some drivers leave the robot's frame empty: then somebody has to say which it is.
void RosStream::meet_odometry(const OdometryMessage& odometry) {
  odom_frame_ = without_slash(odometry.odom_frame);
  base_frame_ = without_slash(odometry.base_frame);
  if (base_frame_.empty()) base_frame_ = decoder_.topics().base_frame;
}

void RosStream::look_at_transforms(const ReceivedMessage& message, bool are_static) {
  // Moving ones are counted while they are played, if they are.
  const bool is_counted = are_static || !decoder_.topics().odometry.empty();
  const auto transforms = decode_transforms(message.bytes(), message.topic.wire, is_counted ? &defects_ : nullptr);
  if (!transforms && are_static) ++defects_["damaged TFMessage"];
  for (const Transform& transform : transforms.value_or(std::vector<Transform>{})) {
    const bool is_motion = !are_static && is_odometry(transform, decoder_.topics());
    if (is_motion && decoder_.topics().odometry.empty() && base_frame_.empty()) {
      base_frame_ = without_slash(transform.child);
      decoder_.take_odometry_from_transforms(base_frame_);
    }
    if (are_static) static_.add(transform, message.topic.name, true);
    if (!are_static) newest_stamp_s_ = std::max(newest_stamp_s_, transform.stamp_s);
    if (!are_static && !is_motion) look_at_link(transform, message.topic.name);
  }
}

/// Drivers may begin late, and stamps may go slower than this clock: each link has its own time to stand still in.
void RosStream::look_at_link(Transform transform, const std::string& topic) {
  SeenTransforms& moving = transform.stamp_s == 0 ? unstamped_ : moving_;
  if (transform.stamp_s == 0) transform.stamp_s = newest_s_;
  const auto seen = moving.by_link().find({without_slash(transform.parent), without_slash(transform.child)});
  if (seen == moving.by_link().end() || transform.stamp_s <= seen->second.first.stamp_s + kMountWindow_s)
    moving.add(transform, topic, false);
}

/// A recording with a part of them would be replayed with them.
void RosStream::drop_other_odometry() {
  std::erase_if(held_, [&](const ReceivedMessage& held) {
    const bool is_other = has_odometry(held.topic) && held.topic.name != decoder_.topics().odometry;
    if (is_other) held_bytes_ -= held.data.size();
    return is_other;
  });
}

void RosStream::bound_memory() {
  while (held_bytes_ > kMostHeldBytes && held_.size() > 1) {
    held_bytes_ -= held_.front().data.size();
    held_.pop_front();
    ++defects_["message that was dropped, because it waited too long"];
  }
}

FixedFrames RosStream::frames() const {
  FixedFrames frames = static_.fixed_frames();
  const auto add_still = [&](const SeenTransforms& moving, double now_s) {
    for (const auto& [link, seen] : moving.by_link())
      if (!seen.moves && now_s > seen.first.stamp_s + kMountWindow_s) frames.add_unless_known(seen.last);
  };
  add_still(moving_, newest_stamp_s_);
  add_still(unstamped_, newest_s_);
  return frames;
}

void RosStream::try_to_open() {
  const bool has_all_lasers = laser_by_topic_.size() >= scan_topics_.size();
  const bool waited_enough = std::ranges::any_of(
      laser_by_topic_, [&](const auto& laser) { return is_over(laser.second.since_s, kLaserPatience_s); });
  if (!hears_odometry() || !(has_all_lasers || waited_enough)) return;
  const FixedFrames known = frames();
  const bool has_all_mounts = std::ranges::all_of(laser_by_topic_, [&](const auto& laser) {
    return !base_frame_.empty() && find_laser_mount(known, base_frame_, laser.second.frame);
  });
  if (!has_all_mounts && !is_over(first_s_, mount_patience_s_)) return;
  for (const auto& [topic, laser] : laser_by_topic_) admit(topic);
  drop_other_odometry();
  is_open_ = true;
}

/// With its mount, if it is known.
void RosStream::admit(const std::string& topic) {
  admitted_.insert(topic);
  const std::string& laser = laser_by_topic_.at(topic).frame;
  const auto is_of_laser = [&](const MountRecord& mount) { return mount.child == laser; };
  if (std::ranges::any_of(mounts_, is_of_laser)) return;
  const auto mount = base_frame_.empty() ? std::nullopt : find_laser_mount(frames(), base_frame_, laser);
  if (!mount) ++defects_["no static transform from " + base_words() + " to " + laser];
  if (!mount) return;
  decoder_.add_mount(*mount);
  mounts_.push_back(mount->record);
}

void RosStream::admit_late_lasers() {
  for (const auto& [topic, laser] : laser_by_topic_) {
    if (admitted_.contains(topic)) continue;
    const bool has_mount = !base_frame_.empty() && find_laser_mount(frames(), base_frame_, laser.frame);
    if (has_mount || is_over(laser.since_s, mount_patience_s_)) admit(topic);
  }
}

std::vector<std::string> RosStream::absent_lasers() const {
  std::vector<std::string> absent;
  if (!is_open_) return absent;
  for (const std::string& topic : scan_topics_)
    if (!admitted_.contains(topic)) absent.push_back(topic);
  return absent;
}

bool RosStream::is_of_absent_laser(const Topic& topic) const {
  return reads_scans_of(decoder_.topics(), topic.name) && !admitted_.contains(topic.name);
}

std::optional<StreamedMessage> RosStream::next() {
  if (!is_open_ || held_.empty()) return std::nullopt;
  StreamedMessage streamed{std::move(held_.front()), std::nullopt};
  held_.pop_front();
  held_bytes_ -= streamed.message.data.size();
  if (is_of_absent_laser(streamed.message.topic)) return streamed;
  streamed.record =
      decoder_.decode(streamed.message.topic, streamed.message.bytes(), seconds_of(streamed.message.received_ns));
  return streamed;
}

std::string RosStream::base_words() const {
  return base_frame_.empty() ? "the robot (" + decoder_.topics().odometry + " does not name its frame)" : base_frame_;
}

std::string RosStream::waits_for() const {
  std::vector<std::string> missing;
  if (is_open_) return "";
  for (const std::string& topic : scan_topics_)
    if (!laser_by_topic_.contains(topic)) missing.push_back("scans on " + topic);
  const std::string& odometry = decoder_.topics().odometry;
  if (!hears_odometry() && !odometry.empty()) missing.push_back("odometry on " + odometry);
  if (!hears_odometry() && odometry.empty())
    missing.push_back("the transform from " + decoder_.topics().odom_frame + " to " +
                      (decoder_.topics().base_frame.empty() ? "the robot" : decoder_.topics().base_frame) + " on /tf");
  if (hears_odometry())
    for (const auto& [topic, laser] : laser_by_topic_)
      if (!first_s_ || base_frame_.empty() || !find_laser_mount(frames(), base_frame_, laser.frame))
        missing.push_back("the transform from " + base_words() + " to " + laser.frame + " on /tf_static");
  return listed(missing);
}

Defects RosStream::defects() const {
  Defects all = defects_;
  for (const auto& [cause, times] : decoder_.defects()) all[cause] += times;
  return all;
}

}  // namespace opal::recording
