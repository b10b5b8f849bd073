#include "recording/ros_log_reader.hpp"

#include <algorithm>
#include <utility>

namespace opal::recording {
namespace {

void add_all(Defects& all, const Defects& more) {
  for (const auto& [cause, times] : more) all[cause] += times;
}

}  // namespace

RosLogReader::RosLogReader(Parts parts, ChosenTopics chosen)
    : parts_(std::move(parts)), decoder_(std::move(chosen.topics)) {
  for (const std::string& remark : chosen.remarks) ++defects_[remark];
  for (const auto& part : parts_) {
    add_all(defects_, part->defects());
    spans_.push_back(span_of(*part));
    end_s_ = std::max(end_s_, spans_.back().end_s);
  }
  reached_s_ = spans_.front().begin_s;
  if (decoder_.topics().odometry.empty()) {
    const OdometryLink link = find_odometry_link(parts_, decoder_.topics());
    if (link.exists) decoder_.take_odometry_from_transforms(link.base_frame);
    if (!link.exists) ++defects_[link.complaint];
  }
  find_mounts();
}

SeenTransforms RosLogReader::read_transforms(bool with_moving) {
  SeenTransforms seen;
  const double until_s = spans_.front().begin_s + kMountWindow_s;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Recording& part = *parts_[i];
    if (with_moving && spans_[i].begin_s > until_s) break;
    const auto walk =
        part.walk(topics_where(part, [&](const Topic& topic) { return has_transforms(topic, !with_moving); }));
    while (const auto message = walk->next()) {
      if (with_moving && seconds_of(message->recorded_ns) > until_s) break;
      const Topic& topic = part.topics()[message->topic];
      const auto transforms = decode_transforms(message->data, topic.wire, with_moving ? nullptr : &defects_);
      // Moving transforms are counted while they are played, if they are.
      if (!transforms && !with_moving) ++defects_["damaged TFMessage"];
      for (const Transform& transform : transforms.value_or(std::vector<Transform>{}))
        if (!with_moving || !is_odometry(transform, decoder_.topics())) seen.add(transform, topic.name, !with_moving);
    }
  }
  return seen;
}

template <class Wanted, class Decoder>
std::optional<Wanted> RosLogReader::first_of(const std::string& topic, Decoder decoder) const {
  for (const auto& part : parts_) {
    const auto walk = part->walk(topics_where(*part, is_named(topic)));
    while (const auto message = walk->next())
      if (std::optional<Wanted> decoded = decoder(part->topics()[message->topic], message->data)) return decoded;
  }
  return std::nullopt;
}

std::string RosLogReader::base_frame_of(const FixedFrames& frames, const std::string& laser_frame) const {
  if (decoder_.transforms_are_odometry()) return decoder_.topics().base_frame;
  const auto odometry = first_of<OdometryMessage>(
      decoder_.topics().odometry, [](const Topic& topic, Bytes data) { return decode_odometry(data, topic.wire); });
  if (odometry && odometry->base_frame.empty()) return decoder_.topics().base_frame;
  return odometry ? odometry->base_frame : frames.root_of(laser_frame);
}

void RosLogReader::add_still_links(FixedFrames& frames) {
  if (std::exchange(knows_still_links_, true)) return;
  const SeenTransforms moving = read_transforms(true);
  for (const auto& [link, seen] : moving.by_link())
    if (!seen.moves) frames.add_unless_known(seen.last);
}

void RosLogReader::find_mounts() {
  std::vector<std::string> laser_frames;
  for (const std::string& topic : scan_topics_of(decoder_.topics()))
    if (const auto frame = first_of<std::string>(topic, frame_of))
      if (std::ranges::find(laser_frames, *frame) == laser_frames.end()) laser_frames.push_back(*frame);
  if (laser_frames.empty()) return;
  FixedFrames frames = read_transforms(false).fixed_frames();
  for (const std::string& frame : laser_frames) find_mount(frames, frame);
}

void RosLogReader::find_mount(FixedFrames& frames, const std::string& laser_frame) {
  const std::string base = base_frame_of(frames, laser_frame);
  std::optional<LaserMount> mount = find_laser_mount(frames, base, laser_frame);
  const bool has_base = decoder_.transforms_are_odometry() || !decoder_.topics().odometry.empty();
  if (!mount && has_base) {
    add_still_links(frames);
    mount = find_laser_mount(frames, base, laser_frame);
  }
  const bool stands_alone = !has_base && base == laser_frame;  // nothing carries it
  if (!mount || stands_alone) {
    ++defects_["no static transform from " + (stands_alone ? "anything" : base) + " to " + laser_frame];
    return;
  }
  decoder_.add_mount(*mount);
  mounts_.push_back(mount->record);
}

std::optional<Message> RosLogReader::next_message() {
  for (; part_ < parts_.size(); ++part_) {
    const Recording& part = *parts_[part_];
    if (!walk_) walk_ = part.walk(topics_where(part, [this](const Topic& topic) { return decoder_.reads(topic); }));
    if (auto message = walk_->next()) return message;
    add_all(defects_, walk_->defects());
    walk_.reset();
  }
  return std::nullopt;
}

std::optional<LogRecord> RosLogReader::next() {
  if (!mounts_.empty()) {
    const MountRecord mount = mounts_.front();
    mounts_.pop_front();
    return mount;
  }
  while (const auto message = next_message()) {
    reached_s_ = seconds_of(message->recorded_ns);
    const Topic& topic = parts_[part_]->topics()[message->topic];
    if (auto record = decoder_.decode(topic, message->data, reached_s_)) return record;
  }
  return std::nullopt;
}

std::map<std::string, int> RosLogReader::defects() const {
  Defects all = defects_;
  add_all(all, decoder_.defects());
  if (walk_) add_all(all, walk_->defects());
  return all;
}

double RosLogReader::progress() const {
  if (part_ == parts_.size()) return 1;
  const double whole_s = end_s_ - spans_.front().begin_s;
  return whole_s > 0 ? std::clamp((reached_s_ - spans_.front().begin_s) / whole_s, 0.0, 1.0) : 0;
}

}  // namespace opal::recording
