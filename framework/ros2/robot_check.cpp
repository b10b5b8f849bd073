#include "ros2/robot_check.hpp"

#include "recording/ros_contents.hpp"
#include "ros2/message_recorder.hpp"
#include "ros2/odometry/odometry_agreement.hpp"

#include <opal/recording/mcap_recording.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <sstream>

namespace opal::ros2 {
namespace {

const std::string kCloudType = "sensor_msgs/msg/PointCloud2";
const std::set<std::string> kHeard{"sensor_msgs/msg/LaserScan", kCloudType, "nav_msgs/msg/Odometry",
                                   "tf2_msgs/msg/TFMessage"};
constexpr int kEnoughClouds = 20;  // of each topic: they are large

bool is_static(const Offer& offer) { return offer.topic.ends_with("tf_static"); }

/// Listens to everything that localization could use. Only what is chosen is missed if it is silent.
void want_all(Incoming& incoming, const recording::TopicChoice& choice) {
  for (const Offer& offer : incoming.offers())
    if (kHeard.contains(offer.type) && !incoming.wants(offer.topic))
      incoming.want({offer.topic, offer.type, is_chosen(choice, offer.topic), is_static(offer)});
}

/// All messages of some seconds as a recording in memory.
std::string record(Incoming& incoming, const recording::TopicChoice& choice, double seconds,
                   const std::stop_token& stop) {
  constexpr double kTurnS = 0.05;
  std::ostringstream out;
  MessageRecorder recorder(out, "the robot");
  std::map<std::string, int> clouds;  // by topic
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (Clock::now() < end && !stop.stop_requested()) {
    incoming.adapt();
    want_all(incoming, choice);
    incoming.take(kTurnS, [&](const recording::ReceivedMessage& message) {
      const recording::Topic& topic = message.topic;
      if (topic.type != kCloudType || ++clouds[topic.name] <= kEnoughClouds) recorder.write(message);
    });
  }
  recorder.finish();
  return out.str();
}

template <class Things>
bool some_read(const Things& things) {
  return std::any_of(things.begin(), things.end(), [](const auto& thing) { return thing.is_read; });
}

std::vector<std::string> missing_in(const LogContents& contents, const std::vector<Offer>& offers) {
  if (offers.empty()) return {"nobody publishes anything"};
  std::vector<std::string> missing;
  if (!some_read(contents.lasers) && contents.clouds.empty())
    missing.push_back("no scan has come (sensor_msgs/msg/LaserScan), and no point cloud (" + kCloudType + ")");
  if (!some_read(contents.odometries))
    missing.push_back("no odometry has come: neither a transform from odom on /tf nor nav_msgs/msg/Odometry");
  for (const LogLaser& laser : contents.lasers)
    if (laser.is_read && !laser.mount)
      missing.push_back(laser.topic + ": no transform leads from the robot to " + laser.frame +
                        ": the deployment has to state where it is mounted");
  for (const LogCloud& cloud : contents.clouds)
    if (!some_read(contents.lasers) && !cloud.mount)
      missing.push_back(cloud.topic + ": no transform leads from the robot to " + cloud.frame +
                        ": the deployment has to state where it is mounted, with height and tilt");
  return missing;
}

OdometrySource source_of(const recording::Recording& recorded, const LogOdometry& odometry) {
  using namespace recording;
  const auto topics = topics_where(recorded, is_named(odometry.topic));
  OdometrySource source{odometry.topic, odometry.odom_frame, odometry.base_frame, {}};
  const auto walk = recorded.walk(topics);
  while (const auto message = walk->next()) {
    const Topic& topic = recorded.topics()[message->topic];
    if (has_odometry(topic)) {
      if (const auto decoded = decode_odometry(message->data, topic.wire))
        source.T_odom_base.push_back({decoded->odometry.stamp_s, decoded->odometry.T_odom_base});
      continue;
    }
    source.name = "the transform on " + odometry.topic;
    for (const Transform& link : decode_transforms(message->data, topic.wire).value_or(std::vector<Transform>{}))
      if (without_slash(link.parent) == odometry.odom_frame && without_slash(link.child) == odometry.base_frame)
        source.T_odom_base.push_back({link.stamp_s, projected(link.T_parent_child)});
  }
  return source;
}

/// The odometry that is read against all others.
std::vector<std::string> odometry_doubts(const recording::Recording& recorded, const LogContents& contents) {
  std::vector<std::string> doubts;
  for (const LogOdometry& used : contents.odometries)
    for (const LogOdometry& other : contents.odometries) {
      if (!used.is_read || other.is_read) continue;
      const auto words = disagreements(source_of(recorded, used), source_of(recorded, other));
      doubts.insert(doubts.end(), words.begin(), words.end());
    }
  return doubts;
}

}  // namespace

bool is_chosen(const recording::TopicChoice& choice, const std::string& topic) {
  return topic == choice.odometry || recording::reads_scans_of(choice, topic);
}

RobotContents look_at_robot(const DiscoveryRange& range, const recording::TopicChoice& choice,
                            recording::OdometryFirst first, double seconds, const std::stop_token& stop) {
  const Participant participant(range);
  Incoming incoming(participant);
  RobotContents seen;
  recording::TopicChoice needed = choice;
  if (first == recording::OdometryFirst::transforms) needed.odometry.clear();
  const std::string recorded = record(incoming, needed, seconds, stop);
  recording::Parts parts;
  parts.push_back(recording::read_mcap(std::make_unique<std::istringstream>(recorded), "the robot"));
  seen.contents = recording::ros_contents("the robot", parts, choice, first);
  seen.contents.format = "Robot in " + words_of(range);
  seen.doubts = odometry_doubts(*parts.front(), seen.contents);
  seen.offers = incoming.offers();
  seen.missing = missing_in(seen.contents, seen.offers);
  for (const std::string& complaint : incoming.complaints()) seen.missing.push_back(complaint);
  return seen;
}

std::string offers_text(const std::vector<Offer>& offers) {
  std::set<std::string> lines;
  for (const Offer& offer : offers)
    lines.insert(fmt::format("  {:<28} {:<44} {}\n", offer.topic, offer.type, words_of(offer.quality)));
  std::string text = "on the network\n";
  if (lines.empty()) text += "  nothing\n";
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace opal::ros2
