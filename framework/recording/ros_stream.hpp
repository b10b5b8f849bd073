#pragma once

#include "recording/record_decoder.hpp"

#include <deque>
#include <limits>

namespace opal::recording {

/// A message as a running robot sent it.
struct ReceivedMessage {
  Topic topic;
  std::int64_t received_ns = 0;  ///< since 1970
  std::vector<std::byte> data;

  Bytes bytes() const { return data; }
};

/// A message whose turn has come.
struct StreamedMessage {
  ReceivedMessage message;
  std::optional<LogRecord> record;  ///< what it holds for localization
};

/// The messages of a running robot, one at a time, as the records that a recording of them would give. Messages are
/// held until it is known where the lasers are mounted; memory is bounded, the oldest go first. A laser that says
/// nothing is not waited for without end: the others go on, and it joins when its first scan and its mount have come.
class RosStream {
 public:
  /// From the first scan of another laser on, a laser is waited for so long.
  static constexpr double kLaserPatience_s = 3;

  /// @param topics  the scans have to be named; without a topic of odometry transforms are it.
  /// @param mount_patience_s  how long to wait for mounts, from the first message; infinite: as long as it takes.
  explicit RosStream(TopicChoice topics, double mount_patience_s = std::numeric_limits<double>::infinity());

  /// Instead of transforms. For a stream that is still closed.
  void take_odometry_from_topic(const std::string& topic);
  /// Instead of a topic. @return false if the stream is open, and goes by another frame of the robot: nothing has
  /// changed then.
  bool take_odometry_from_transforms(const std::string& base_frame);
  /// The next message in the order of arrival. Messages of odometry that turn out not to be read are dropped when the
  /// stream opens.
  void take(ReceivedMessage message);
  /// In the order of arrival; nullopt if there is none or it is held.
  std::optional<StreamedMessage> next();

  /// Whether messages are not held any more.
  bool is_open() const { return is_open_; }
  /// Whether a message of odometry has told the robot's frame.
  bool knows_the_robot() const { return !base_frame_.empty(); }
  /// The frame that messages of odometry give poses in; empty: transforms are the odometry, or no message has come.
  std::string odom_frame() const { return odom_frame_.value_or(""); }
  /// Topics of lasers that an open stream goes on without: no scan has come yet, or the mount is not known.
  std::vector<std::string> absent_lasers() const;
  /// Where the lasers are mounted, as far as frames lead there; of an open stream. Those of late lasers come last.
  const std::vector<MountRecord>& mounts() const { return mounts_; }
  /// What messages are held for, in words; empty if it is open.
  std::string waits_for() const;
  /// What was damaged or dropped.
  Defects defects() const;

 private:
  void look_at(const ReceivedMessage& message);
  void meet_odometry(const OdometryMessage& odometry);
  bool hears_odometry() const { return odom_frame_ || !base_frame_.empty(); }
  std::string base_words() const;
  void look_at_transforms(const ReceivedMessage& message, bool are_static);
  void look_at_link(Transform transform, const std::string& topic);
  void drop_other_odometry();
  void bound_memory();
  FixedFrames frames() const;
  bool is_over(const std::optional<double>& since_s, double patience_s) const {
    return since_s && newest_s_ - *since_s >= patience_s;
  }
  void try_to_open();
  void admit(const std::string& topic);
  void admit_late_lasers();
  bool is_of_absent_laser(const Topic& topic) const;

  struct SeenLaser {
    std::string frame;
    double since_s = 0;  ///< when its first scan was received
  };

  RecordDecoder decoder_;
  std::vector<std::string> scan_topics_;  // that are described
  double mount_patience_s_;
  std::deque<ReceivedMessage> held_;
  std::size_t held_bytes_ = 0;
  std::optional<double> first_s_;  // when the first message was received
  double newest_s_ = 0;
  std::string base_frame_;                 // empty: not known yet, or not named
  std::optional<std::string> odom_frame_;  // of messages of odometry, once one has come
  std::map<std::string, SeenLaser> laser_by_topic_;
  std::set<std::string> admitted_;              // topics of lasers that are used, of an open stream
  SeenTransforms static_, moving_, unstamped_;  // of the last, the time of receipt is the stamp
  double newest_stamp_s_ = 0;                   // of transforms that move
  std::vector<MountRecord> mounts_;
  bool is_open_ = false;
  Defects defects_;
};

}  // namespace opal::recording
