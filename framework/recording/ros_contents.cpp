#include "recording/ros_contents.hpp"

#include <opal/common/error.hpp>
#include <opal/common/quantile.hpp>
#include "recording/cloud_tally.hpp"
#include "recording/fixed_frames.hpp"
#include "recording/record_decoder.hpp"
#include "sensing/log_tally.hpp"

#include <fmt/format.h>

#include <cmath>

namespace opal::recording {
namespace {

// About a second on a small computer.
constexpr std::uint64_t kMostLookedAtBytes = 300'000'000;

struct SeenLaser {
  LaserTally tally;
  LogLaser laser;
  std::vector<double> delays_s;
};

struct SeenOdometry {
  OdometryTally tally;
  LogOdometry odometry;
  std::vector<double> delays_s;
};

/// The topics of all files with their rates.
std::vector<LogTopic> tally_topics(const Parts& parts) {
  using Name = std::pair<std::string, std::string>;  // and type
  std::map<Name, StampTally> tallies;
  for (const auto& part : parts) {
    std::vector<StampTally*> by_index;
    for (const Topic& topic : part->topics())
      by_index.push_back(&tallies.try_emplace(Name(topic.name, topic.type)).first->second);
    for (const RecordedStamp& stamp : part->stamps()) by_index[stamp.topic]->add(seconds_of(stamp.recorded_ns));
  }
  std::vector<LogTopic> topics;
  for (const auto& [name, tally] : tallies) {
    LogTopic topic;
    topic.name = name.first;
    topic.type = name.second;
    tally.tell(topic);
    topics.push_back(topic);
  }
  return topics;
}

/// Looks at messages one after the other.
class MessageTally {
 public:
  explicit MessageTally(TopicChoice chosen) : chosen_(std::move(chosen)) {}

  void walk(const Recording& part) {
    const auto walk = part.walk(topics_where(part, [](const Topic& topic) {
      return has_scans(topic) || has_odometry(topic) || has_transforms(topic, true) || has_transforms(topic, false);
    }));
    while (looked_at_bytes_ < kMostLookedAtBytes) {
      const auto message = walk->next();
      if (!message) break;
      looked_at_bytes_ += message->data.size();
      looked_at_s_ = seconds_of(message->recorded_ns);
      take(*message, part.topics()[message->topic]);
    }
    for (const auto& [cause, times] : walk->defects()) defects_[cause] += times;
  }
  bool is_full() const { return looked_at_bytes_ >= kMostLookedAtBytes; }
  double looked_at_s() const { return looked_at_s_; }
  void tell(LogContents& contents) const;
  void tell(LogContents& contents, const std::map<std::string, CloudTally>& clouds) const;

 private:
  void take(const Message& message, const Topic& topic) {
    const double recorded_s = seconds_of(message.recorded_ns);
    if (has_scans(topic)) return take_scan(message, topic, recorded_s);
    if (has_odometry(topic)) return take_odometry(message, topic, recorded_s);
    take_transforms(message, topic, recorded_s);
  }
  void take_scan(const Message& message, const Topic& topic, double recorded_s);
  void take_odometry(const Message& message, const Topic& topic, double recorded_s);
  void take_transforms(const Message& message, const Topic& topic, double recorded_s);
  void add_pose(SeenOdometry& seen, const OdometryRecord& record, double recorded_s);
  std::string base_frame() const;
  std::string parent_of(const std::string& frame) const;
  std::optional<Eigen::Isometry3d> pose_of(const std::string& frame) const;
  std::optional<LogMount> mount_of(const std::string& frame) const;

  TopicChoice chosen_;
  std::map<std::string, SeenLaser> lasers_;         // by topic
  std::map<std::string, SeenOdometry> odometries_;  // by topic
  SeenTransforms transforms_;
  Defects defects_;
  std::uint64_t looked_at_bytes_ = 0;
  double looked_at_s_ = 0;
};

void MessageTally::take_scan(const Message& message, const Topic& topic, double recorded_s) {
  const auto decoded = decode_laser_scan(message.data, topic.wire);
  if (!decoded) {
    ++defects_["damaged LaserScan message"];
    return;
  }
  SeenLaser& seen = lasers_[topic.name];
  seen.tally.add(decoded->scan);
  seen.laser.topic = topic.name;
  seen.laser.is_read = reads_scans_of(chosen_, topic.name);
  seen.laser.range_min_m = decoded->range_min_m;
  seen.laser.range_max_m = decoded->range_max_m;
  seen.laser.sweep_s = decoded->scan.time_increment_s * (static_cast<double>(decoded->scan.ranges_m.size()) - 1);
  if (decoded->scan.stamp_s != 0) seen.delays_s.push_back(recorded_s - decoded->scan.stamp_s);
}

void MessageTally::add_pose(SeenOdometry& seen, const OdometryRecord& record, double recorded_s) {
  seen.tally.add(record.T_odom_base);
  if (record.stamp_s != 0) seen.delays_s.push_back(recorded_s - record.stamp_s);
}

void MessageTally::take_odometry(const Message& message, const Topic& topic, double recorded_s) {
  const auto decoded = decode_odometry(message.data, topic.wire);
  if (!decoded) {
    ++defects_["damaged Odometry message"];
    return;
  }
  SeenOdometry& seen = odometries_[topic.name];
  seen.odometry.topic = topic.name;
  seen.odometry.odom_frame = without_slash(decoded->odom_frame);
  seen.odometry.base_frame = without_slash(decoded->base_frame);
  seen.odometry.is_read = topic.name == chosen_.odometry;
  add_pose(seen, decoded->odometry, recorded_s);
}

void MessageTally::take_transforms(const Message& message, const Topic& topic, double recorded_s) {
  const auto decoded = decode_transforms(message.data, topic.wire, &defects_);
  if (!decoded) ++defects_["damaged TFMessage"];
  const bool are_static = has_transforms(topic, true);
  for (const Transform& transform : decoded.value_or(std::vector<Transform>{})) {
    transforms_.add(transform, topic.name, are_static);
    if (are_static || !is_odometry(transform, chosen_)) continue;
    SeenOdometry& seen = odometries_[topic.name];
    seen.odometry.topic = topic.name;
    seen.odometry.odom_frame = without_slash(transform.parent);
    if (seen.odometry.base_frame.empty()) seen.odometry.base_frame = without_slash(transform.child);
    seen.odometry.is_read = chosen_.odometry.empty();
    if (seen.odometry.base_frame == without_slash(transform.child))
      add_pose(seen, {transform.stamp_s, projected(transform.T_parent_child)}, recorded_s);
  }
}

std::string MessageTally::base_frame() const {
  for (const auto& [topic, seen] : odometries_)
    if (seen.odometry.is_read) return seen.odometry.base_frame;
  return odometries_.empty() ? "" : odometries_.begin()->second.odometry.base_frame;
}

std::string MessageTally::parent_of(const std::string& frame) const {
  return base_frame().empty() ? transforms_.fixed_frames().root_of(frame) : base_frame();
}

/// Where a sensor is on the robot.
std::optional<Eigen::Isometry3d> MessageTally::pose_of(const std::string& frame) const {
  const std::string base = parent_of(frame);
  if (base_frame().empty() && base == without_slash(frame)) return std::nullopt;
  return transforms_.fixed_frames().pose(base, frame);
}

std::optional<LogMount> MessageTally::mount_of(const std::string& frame) const {
  const std::optional<Eigen::Isometry3d> T_base_laser = pose_of(frame);
  if (!T_base_laser) return std::nullopt;
  const std::string base = parent_of(frame);
  LogMount mount;
  mount.parent = base;
  mount.T_base_laser = projected(*T_base_laser);
  mount.height_m = T_base_laser->translation().z();
  const double upright = T_base_laser->linear()(2, 2);
  mount.upside_down = upright < 0;
  mount.tilt_rad = std::acos(std::min(1.0, std::abs(upright)));
  FixedFrames stated;
  for (const auto& [link, seen] : transforms_.by_link())
    if (seen.is_static) stated.add(seen.last);
  mount.from_moving_topic = !stated.pose(base, frame);
  return mount;
}

void MessageTally::tell(LogContents& contents) const {
  for (const auto& [topic, seen] : lasers_) {
    contents.lasers.push_back(seen.laser);
    seen.tally.tell(contents.lasers.back());
    contents.lasers.back().recorded_after_s = median_of(seen.delays_s).value_or(0);
    contents.lasers.back().mount = mount_of(contents.lasers.back().frame);
  }
  for (const auto& [topic, seen] : odometries_) {
    contents.odometries.push_back(seen.odometry);
    seen.tally.tell(contents.odometries.back());
    contents.odometries.back().recorded_after_s = median_of(seen.delays_s).value_or(0);
  }
  for (const auto& [link, seen] : transforms_.by_link())
    contents.transforms.push_back({link.first, link.second, seen.topic, seen.messages, seen.is_static, seen.moves});
  for (const auto& [cause, times] : defects_) contents.defects[cause] += times;
}

void MessageTally::tell(LogContents& contents, const std::map<std::string, CloudTally>& clouds) const {
  for (const auto& [topic, tally] : clouds) {
    contents.clouds.push_back(tally.told(topic, pose_of(tally.frame())));
    contents.clouds.back().mount = mount_of(tally.frame());
  }
}

void tell_options(LogContents& contents, const TopicChoice& chosen) {
  if (chosen.scans.size() == 1) contents.options.emplace_back("scan_topic", chosen.scans.front());
  if (chosen.scans.size() > 1)
    contents.options.emplace_back("scan_topics", fmt::format("{}", fmt::join(chosen.scans, ",")));
  if (!chosen.odometry.empty()) contents.options.emplace_back("odometry_topic", chosen.odometry);
  for (const LogOdometry& odometry : contents.odometries)
    if (odometry.is_read && chosen.odometry.empty()) {
      contents.options.emplace_back("odom_frame", odometry.odom_frame);
      contents.options.emplace_back("base_frame", odometry.base_frame);
    }
}

}  // namespace

LogContents ros_contents(const std::string& path, const Parts& parts, TopicChoice wanted, OdometryFirst first) {
  LogContents contents;
  wanted.are_all_slices = wanted.scans.empty() && has_only_clouds(parts);
  ChosenTopics chosen{wanted, {}};
  try {
    chosen = choose_topics(path, parts, wanted, first);
    for (const std::string& remark : chosen.remarks) ++contents.defects[remark];
  } catch (const LogError& error) {
    ++contents.defects[error.what()];  // there is something to tell all the same
  }
  contents.topics = tally_topics(parts);
  contents.first_s = span_of(*parts.front()).begin_s;
  MessageTally tally(chosen.topics);
  for (const auto& part : parts) {
    for (const auto& [cause, times] : part->defects()) contents.defects[cause] += times;
    contents.last_s = std::max(contents.last_s, span_of(*part).end_s);
    if (!tally.is_full()) tally.walk(*part);
  }
  contents.looked_at_s = tally.is_full() ? tally.looked_at_s() : contents.last_s;
  tally.tell(contents);
  tally.tell(contents, tally_clouds(parts, contents.defects));
  tell_options(contents, chosen.topics);
  return contents;
}

}  // namespace opal::recording
