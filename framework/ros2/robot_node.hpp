#pragma once

#include "ros2/health_report.hpp"
#include "ros2/incoming.hpp"
#include "ros2/late_lasers.hpp"
#include "ros2/message_recorder.hpp"
#include "ros2/messages/outgoing.hpp"
#include "ros2/network/discovery_range.hpp"
#include "ros2/odometry/odom_frame.hpp"
#include "ros2/odometry/odometry_comparison.hpp"
#include "ros2/odometry/odometry_patience.hpp"
#include "ros2/pose_keeper.hpp"
#include "ros2/pose_memory.hpp"
#include "ros2/service_notice.hpp"

#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <thread>

namespace opal::ros2 {

/// What a node listens to.
struct IncomingTopics {
  std::string initial_pose = "/initialpose";  ///< a hint
  std::string forget = "/opal/forget";        ///< Empty: as if nothing had been seen
  std::string tf = "/tf", tf_static = "/tf_static", clock = "/clock";
};

struct NodeOptions {
  /// Scans have to be named; without odometry transforms are it, or the usual topic. What hints are, and who wants all
  /// to be forgotten, is in `incoming`.
  recording::TopicChoice read;
  IncomingTopics incoming;
  OutgoingTopics outgoing;
  FrameOptions frames;
  DiscoveryRange range;
  bool use_sim_time = false;                ///< "now" is what /clock says
  std::string odometry_without_transforms;  ///< topic that is read if no transform is odometry; empty: the usual one
  bool is_odom_frame_stated = false;        ///< messages of odometry that name another one do not change it
  bool needs_mounts = true;                 ///< the deployment says nothing of them: they have to come
  std::string record_file;                  ///< empty: nothing is kept; if it is there, the next free name is taken
  std::string state_file;                   ///< empty: the last pose is not kept
};

/// What is localized with, once it is known what the lasers are; again where a laser begins later whose geometry only
/// its scans tell.
using MakeParts = std::function<LocalizerParts(std::span<const LogRecord>)>;

/// Gets every record that is localized with, from the thread that runs the node; whoever listens must not take long.
using RecordListener = std::function<void(const LogRecord&)>;

/// Localizes a running robot until it is asked to stop.
class RobotNode {
 public:
  /// @param events  may be null. @param heard  may be empty.
  /// @throws Error if DDS cannot be started, WriteError if a file cannot be written.
  RobotNode(NodeOptions options, std::shared_ptr<const SemanticMap> map, MakeParts make_parts, EventSink* events,
            RecordListener heard = {});
  ~RobotNode();

  /// @throws what `make_parts` throws, if the robot's lasers do not fit the deployment.
  void run(const std::stop_token& stop, ServiceNotice& notice);
  /// The newest answer; of a node that has localized nothing one with the number 0.
  LiveAnswer newest() const { return live_ ? live_->newest() : LiveAnswer{}; }

 private:
  void route(recording::ReceivedMessage message);
  void look_at_transforms(const recording::ReceivedMessage& message);
  void drain();
  void set_clock(const recording::ReceivedMessage& message);
  void record(const recording::ReceivedMessage& message);
  void begin_recording();
  void publish_map();
  void begin();
  void make_localizer(std::vector<LogRecord> records);
  bool begin_anew_with(const std::string& frame);
  bool may_use(const LogRecord& record);
  void localize(LogRecord record, double now_s);
  void fall_back_to_odometry_topic();
  void return_to_transforms(const std::string& base_frame);
  void announce(const std::stop_token& stop);
  void start_announcing();
  void look_around();
  void tell_health(ServiceNotice& notice);
  NodeState state();
  double now_s() const;

  NodeOptions options_;
  std::shared_ptr<const SemanticMap> map_;
  MakeParts make_parts_;
  EventSink* events_;
  RecordListener heard_;
  PoseMemory memory_;
  PoseKeeper keeper_;
  Participant participant_;
  Incoming incoming_;
  std::mutex publishing_;
  Outgoing outgoing_;
  recording::RosStream stream_;
  LateLasers late_lasers_;
  OdometryPatience odometry_patience_;
  OdometryComparison odometry_comparison_;
  bool fell_back_ = false;         // odometry is read from its topic, because no transform was it
  std::string recorded_odometry_;  // a topic that is not read any more, but for the recording
  std::optional<FileRecorder> recorder_;
  std::vector<LogRecord> before_;  // records from before the localizer was made
  std::optional<double> sim_time_s_;
  double other_seen_s_ = -1e9;
  HealthReport report_;
  ServiceNotice* notice_ = nullptr;  // while it runs
  std::unique_ptr<LiveLocalizer> live_;
  std::jthread announcer_;  // ends first
};

}  // namespace opal::ros2
