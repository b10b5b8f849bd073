#include "ros2/robot_node.hpp"

#include <opal/common/error.hpp>
#include "common/write_error.hpp"

#include <chrono>
#include <iostream>
#include <limits>

namespace opal::ros2 {
namespace {

// How long a message may wait for this program to look, if DDS does not wake it.
constexpr double kTickS = 0.05;
constexpr double kLookAroundS = 0.1;
constexpr double kHealthS = 1;
// Another transform from the map is there as long as one was seen in this time.
constexpr double kOthersS = 5;
constexpr double kMountPatienceS = 10;

double steady_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Whether so much time has passed since it last was true.
bool is_due(double& last_s, double interval_s) {
  const double now_s = steady_s();
  if (now_s - last_s < interval_s) return false;
  last_s = now_s;
  return true;
}

recording::RosStream stream_of(const NodeOptions& options) {
  const double forever = std::numeric_limits<double>::infinity();
  recording::TopicChoice topics = options.read;
  topics.hints = options.incoming.initial_pose;
  topics.forget = options.incoming.forget;
  topics.map_frame = options.frames.map;
  return recording::RosStream(std::move(topics), options.needs_mounts ? forever : kMountPatienceS);
}

}  // namespace

RobotNode::RobotNode(NodeOptions options, std::shared_ptr<const SemanticMap> map, MakeParts make_parts,
                     EventSink* events, RecordListener heard)
    : options_(std::move(options)),
      map_(std::move(map)),
      make_parts_(std::move(make_parts)),
      events_(events),
      heard_(std::move(heard)),
      memory_(options_.state_file, map_->name()),
      keeper_([this](const Pose2& T_map_base) { memory_.keep(T_map_base, steady_s()); }),
      participant_(options_.range),
      incoming_(participant_),
      outgoing_(participant_, options_.outgoing, options_.frames),
      stream_(stream_of(options_)),
      report_(std::cerr, steady_s()) {
  const IncomingTopics& topics = options_.incoming;
  for (const std::string& scan : options_.read.scans) incoming_.want({scan, "sensor_msgs/msg/LaserScan"});
  for (const auto& [cloud, laser] : options_.read.slices) incoming_.want({cloud, "sensor_msgs/msg/PointCloud2"});
  if (!options_.read.odometry.empty()) incoming_.want({options_.read.odometry, "nav_msgs/msg/Odometry"});
  incoming_.want({topics.tf, "tf2_msgs/msg/TFMessage", options_.read.odometry.empty()});
  incoming_.want({topics.tf_static, "tf2_msgs/msg/TFMessage", options_.needs_mounts, true});
  incoming_.want({topics.initial_pose, "geometry_msgs/msg/PoseWithCovarianceStamped", false});
  incoming_.want({topics.forget, "std_msgs/msg/Empty", false});
  if (options_.use_sim_time) incoming_.want({topics.clock, "rosgraph_msgs/msg/Clock"});
  if (!options_.record_file.empty()) begin_recording();
}

RobotNode::~RobotNode() = default;

void RobotNode::begin_recording() {
  recorder_.emplace(options_.record_file);
  if (recorder_->path() != options_.record_file)
    std::cerr << "ros2: " << options_.record_file << " is there already: what is received goes into "
              << recorder_->path() << '\n';
}

double RobotNode::now_s() const {
  if (!options_.use_sim_time) return 1e-9 * static_cast<double>(system_ns());
  return sim_time_s_.value_or(std::numeric_limits<double>::quiet_NaN());
}

void RobotNode::run(const std::stop_token& stop, ServiceNotice& notice) {
  publish_map();
  notice.ready();
  notice_ = &notice;
  double looked_s = 0, told_s = 0;
  while (!stop.stop_requested()) {
    incoming_.take(kTickS, [this](recording::ReceivedMessage message) { route(std::move(message)); });
    drain();
    if (is_due(looked_s, kLookAroundS)) look_around();
    if (is_due(told_s, kHealthS)) tell_health(notice);
  }
  notice_ = nullptr;
  notice.stopping();
  announcer_ = {};
  if (recorder_) recorder_->finish();
}

void RobotNode::route(recording::ReceivedMessage message) {
  const IncomingTopics& topics = options_.incoming;
  if (message.topic.name == topics.clock) return set_clock(message);
  if (message.topic.name == topics.tf) look_at_transforms(message);
  if (recording::has_odometry(message.topic) && message.topic.name != options_.read.odometry &&
      message.topic.name != recorded_odometry_) {
    odometry_patience_.odometry_is_heard(steady_s());
    if (stream_.is_open()) return;
  }
  stream_.take(std::move(message));
  drain();
}

void RobotNode::look_at_transforms(const recording::ReceivedMessage& message) {
  const auto transforms = recording::decode_transforms(message.bytes(), message.topic.wire);
  for (const recording::Transform& transform : transforms.value_or(std::vector<recording::Transform>{})) {
    if (recording::without_slash(transform.child) == options_.frames.odom &&
        recording::without_slash(transform.parent) == options_.frames.map)
      other_seen_s_ = steady_s();
    if (options_.read.odometry.empty() || !recording::is_odometry(transform, options_.read)) continue;
    odometry_comparison_.hear_transform({transform.stamp_s, recording::projected(transform.T_parent_child)});
    if (fell_back_) return_to_transforms(recording::without_slash(transform.child));
  }
}

void RobotNode::drain() {
  while (auto next = stream_.next()) {
    record(next->message);
    if (!next->record) continue;
    if (const auto* odometry = std::get_if<OdometryRecord>(&*next->record))
      odometry_comparison_.hear_message(*odometry);
    if (std::holds_alternative<ForgetRecord>(*next->record))
      std::cerr << "ros2: asked on " << options_.incoming.forget << " to forget everything\n";
    if (live_)
      localize(std::move(*next->record), now_s());
    else
      before_.push_back(std::move(*next->record));
  }
  if (!live_ && stream_.is_open()) begin();
}

void RobotNode::record(const recording::ReceivedMessage& message) {
  if (!recorder_) return;
  try {
    recorder_->write(message);
  } catch (const WriteError& error) {  // localization goes on without it
    std::cerr << "ros2: " << error.what() << ": nothing more is recorded\n";
    recorder_.reset();
  }
}

void RobotNode::publish_map() {
  const std::lock_guard lock(publishing_);
  outgoing_.publish_walls(*map_, 0);
  try {
    outgoing_.publish(rasterized(*map_), 0);
  } catch (const MapError& error) {
    std::cerr << "ros2: the map is not published as a grid: " << error.what() << '\n';
  }
}

void RobotNode::announce(const std::stop_token& stop) {
  std::uint64_t told = 0;
  while (!stop.stop_requested()) {
    const auto answer = live_->newer_than(told, kTickS);
    if (!answer) continue;
    told = answer->number;
    const Announcement announcement = announcement_of(*answer, options_.frames);
    const std::lock_guard lock(publishing_);
    outgoing_.publish(announcement);
    if (announcement.pose) keeper_.give(announcement.pose->T_map_base);
  }
}

void RobotNode::set_clock(const recording::ReceivedMessage& message) {
  if (const auto time_s = recording::decode_clock(message.bytes(), message.topic.wire); time_s) sim_time_s_ = time_s;
}

void RobotNode::fall_back_to_odometry_topic() {
  if (!options_.read.odometry.empty() || stream_.is_open() || stream_.knows_the_robot()) return;
  if (incoming_.reads(options_.incoming.tf)) odometry_patience_.transforms_are_read(steady_s());
  const std::string& named = options_.odometry_without_transforms;
  const std::string topic = named.empty() ? usual_odometry(incoming_.offers()) : named;
  if (topic.empty()) return;
  if (!incoming_.wants(topic)) incoming_.want({topic, "nav_msgs/msg/Odometry", false});
  if (!odometry_patience_.is_over(steady_s())) return;
  const std::string& base = options_.read.base_frame;
  std::cerr << "ros2: no transform from " << options_.read.odom_frame << (base.empty() ? "" : " to " + base) << " on "
            << options_.incoming.tf << ": odometry is taken from " << topic << '\n';
  options_.read.odometry = topic;
  fell_back_ = true;
  incoming_.want({topic, "nav_msgs/msg/Odometry"});
  incoming_.want({options_.incoming.tf, "tf2_msgs/msg/TFMessage", false});
  stream_.take_odometry_from_topic(topic);
}

/// The robot's own transform has begun: what others place in the map builds on it.
void RobotNode::return_to_transforms(const std::string& base_frame) {
  fell_back_ = false;
  const std::string topic = options_.read.odometry;
  if (!stream_.take_odometry_from_transforms(base_frame)) {
    std::cerr << "ros2: a transform from " << options_.read.odom_frame << " to " << base_frame << " has begun, and "
              << topic << " is about another frame: start again to use it\n";
    return;
  }
  std::cerr << "ros2: a transform from " << options_.read.odom_frame << " to " << base_frame
            << " has begun: it is the odometry from now on\n";
  if (stream_.is_open()) recorded_odometry_ = topic;  // a recording of which one part has it, needs it to its end
  options_.read.odometry.clear();
  incoming_.want({topic, "nav_msgs/msg/Odometry", false});
  incoming_.want({options_.incoming.tf, "tf2_msgs/msg/TFMessage"});
}

void RobotNode::look_around() {
  incoming_.adapt();
  fall_back_to_odometry_topic();
}

NodeState RobotNode::state() {
  NodeState state{stream_.waits_for(), incoming_.complaints(), stream_.defects(), incoming_.take_rates_hz()};
  if (incoming_.offers().empty()) state.complaints = {"nobody publishes anything (" + words_of(options_.range) + ")"};
  if (steady_s() - other_seen_s_ < kOthersS)
    state.complaints.push_back(options_.incoming.tf + ": somebody else publishes the transform from " +
                               options_.frames.map + " to " + options_.frames.odom + " (AMCL? SLAM?): switch it off");
  if (const std::string& apart = odometry_comparison_.difference(); !apart.empty() && !options_.read.odometry.empty())
    state.complaints.push_back(options_.read.odometry + " and the transform from " + options_.read.odom_frame +
                               " to the robot on " + options_.incoming.tf + " differ by " + apart +
                               ": leave --odometry-topic out, or frames of others are wrong in " + options_.frames.map);
  for (const std::string& topic : stream_.absent_lasers())
    state.complaints.push_back("localization goes on without the laser of " + topic);
  if (live_)
    for (const auto& [cause, times] : live_->counts()) state.odd_counts[cause] += times;
  return state;
}

void RobotNode::tell_health(ServiceNotice& notice) {
  const NodeState now = state();
  const LiveAnswer answer = newest();
  const std::vector<Diagnosis> diagnoses = diagnoses_of(answer, now, now_s());
  {
    const std::lock_guard lock(publishing_);
    outgoing_.publish(diagnoses, options_.use_sim_time ? sim_time_s_.value_or(0) : now_s());
  }
  notice.alive();
  notice.status(diagnoses.front().message);
  report_.status(answer);
  report_.defects(stream_.defects());
  std::vector<std::string> words = now.complaints;
  if (!now.waits_for.empty()) words.push_back("waits for " + now.waits_for);
  if (const std::string clock = clock_complaint(answer, now_s()); !clock.empty()) words.push_back(clock);
  for (const std::string& finding : health_complaints(answer)) words.push_back(finding);
  report_.complaints(words, steady_s());
}

}  // namespace opal::ros2
