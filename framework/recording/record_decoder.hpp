#pragma once

#include "recording/cloud_slicer.hpp"
#include "recording/fixed_frames.hpp"
#include "recording/ros_topics.hpp"

#include <set>

namespace opal::recording {

double seconds_of(std::int64_t nanoseconds);

/// The frame of a message with a scan or a point cloud; nullopt for a damaged one.
std::optional<std::string> frame_of(const Topic& topic, Bytes data);

/// Where a laser sits on the robot.
struct LaserMount {
  MountRecord record;
  Eigen::Isometry3d T_base_laser = Eigen::Isometry3d::Identity();  ///< the same with height and tilt
  bool upside_down = false;
  bool is_tilted = false;  ///< by more than 10 degrees
};

/// @return nullopt if no frames lead from the robot to the laser.
std::optional<LaserMount> find_laser_mount(const FixedFrames& frames, const std::string& base,
                                           const std::string& laser_frame);

/// Turns single messages into the records of a log. Recordings and running robots go through it alike.
class RecordDecoder {
 public:
  /// @param topics  whose scans and odometry are read; without a topic of odometry transforms may be it.
  explicit RecordDecoder(TopicChoice topics);

  const TopicChoice& topics() const { return topics_; }
  /// From now on transforms from the frame of odometry to this one are the odometry, and no topic is.
  void take_odometry_from_transforms(const std::string& base_frame);
  bool transforms_are_odometry() const { return transforms_are_odometry_; }
  /// The beams of lasers that hang upside down are turned the right way round. Point clouds are sliced as it says.
  void add_mount(const LaserMount& mount);
  /// Whether its messages may hold a record.
  bool reads(const Topic& topic) const;
  /// @param received_s  replaces a stamp of zero, which a driver without a clock leaves.
  /// @return nullopt if the message is about something else, or damaged, which is counted.
  std::optional<LogRecord> decode(const Topic& topic, Bytes data, double received_s);
  const Defects& defects() const { return defects_; }

 private:
  std::optional<LogRecord> slice_of(const Topic& topic, Bytes data, double received_s);
  std::optional<LogRecord> scan_of(Bytes data, Wire wire, double received_s);
  std::optional<LogRecord> pose_of(Bytes data, Wire wire, double received_s);
  std::optional<LogRecord> hint_of(Bytes data, Wire wire, double received_s);
  std::optional<LogRecord> transform_of(Bytes data, Wire wire, double received_s);

  TopicChoice topics_;
  bool transforms_are_odometry_ = false;
  std::map<std::string, LaserMount> mounts_;    // by frame
  std::set<std::string> tilted_;                // frames of which nobody has told yet that they are
  std::map<std::string, CloudSlicer> slicers_;  // by topic
  Defects defects_;
};

}  // namespace opal::recording
