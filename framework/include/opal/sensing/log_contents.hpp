#pragma once

#include <opal/common/geometry.hpp>
#include <opal/sensing/scan.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace opal {

/// One stream of messages in a log.
struct LogTopic {
  std::string name;             ///< "/scan", or what the format calls such messages
  std::string type;             ///< of its messages
  std::int64_t messages = 0;    ///< how many there are
  double first_s = 0;           ///< when the first one was recorded, by the clock of the log
  double last_s = 0;            ///< the same of the last one
  double interval_s = 0;        ///< median time between two messages; 0 for fewer than two
  int gaps = 0;                 ///< pauses of more than half a second and five usual intervals
  double longest_gap_s = 0;     ///< the longest pause, 0 for fewer than two messages
  double longest_gap_at_s = 0;  ///< when it began
};

/// Where a laser is mounted, by the log.
struct LogMount {
  std::string parent;              ///< the robot's frame
  Pose2 T_base_laser;              ///< projected on the floor
  double height_m = 0;             ///< above the robot's frame
  double tilt_rad = 0;             ///< of its axis from the vertical, in [0, pi/2]
  bool upside_down = false;        ///< its axis points down
  bool from_moving_topic = false;  ///< stated by transforms that could change, though this one does not
};

/// One laser in a log.
struct LogLaser {
  std::string topic;                          ///< as LogTopic::name
  std::string frame;                          ///< its name in the log
  int scans = 0;                              ///< those that were looked at
  int beams = 0;                              ///< of most scans
  int other_scans = 0;                        ///< scans with another number of beams
  std::optional<double> angle_min_rad;        ///< in the sensor frame, if the log states it
  std::optional<double> angle_increment_rad;  ///< if the log states it; negative: clockwise
  double range_min_m = 0;                     ///< as stated; 0: not stated
  double range_max_m = 0;                     ///< as stated; 0: not stated
  double sweep_s = 0;                         ///< from the first beam of a scan to the last; 0: not stated
  double nearest_m = 0;                       ///< of all returns
  double farthest_m = 0;                      ///< of all returns
  double no_return_share = 0;                 ///< readings at or above range_max, or infinite
  double invalid_share = 0;                   ///< readings that are not finite, zero or below range_min
  double no_return_m = 0;                     ///< the range that stands for no return; 0: none does
  double recorded_after_s = 0;                ///< median time from stamp to recording; 0: not known
  std::optional<LogMount> mount;              ///< if the log states it
  bool is_read = false;                       ///< it is the one that `LogSource::open` reads
};

/// The point clouds of one 3D lidar in a log.
struct LogCloud {
  std::string topic;                ///< as LogTopic::name
  std::string frame;                ///< its name in the log
  int clouds = 0;                   ///< those that were looked at
  std::int64_t width = 0;           ///< points in a row of the first cloud
  std::int64_t height = 0;          ///< its rows; 1: the points have no order
  std::vector<std::string> fields;  ///< "x FLOAT32", in the order of the message
  double valid_share = 0;           ///< of the points that were looked at: they are finite, and not at the sensor
  std::string time_field;           ///< when each point was measured; empty: not stated in a way that is known
  double sweep_s = 0;               ///< from the first point of a cloud to the last; 0: not stated
  std::optional<LogMount> mount;    ///< if the log states it
  double x_min_m = 0;               ///< of the points; in the robot's frame if the mount is known, else the sensor's
  double x_max_m = 0;               ///< the same
  double y_min_m = 0;               ///< the same
  double y_max_m = 0;               ///< the same
  double z_min_m = 0;               ///< the same
  double z_max_m = 0;               ///< the same
  double farthest_m = 0;            ///< horizontal distance from the sensor that one point in a hundred exceeds
  std::optional<CloudSlice> suggested;  ///< between floor and ceiling; none without points
};

/// One source of odometry in a log.
struct LogOdometry {
  std::string topic;            ///< as LogTopic::name
  std::string odom_frame;       ///< in which it is given
  std::string base_frame;       ///< what moves
  int poses = 0;                ///< those that were looked at
  double driven_m = 0;          ///< path length
  double turned_rad = 0;        ///< sum of all turns, whatever their sense
  double recorded_after_s = 0;  ///< median time from stamp to recording; 0: not known
  bool is_read = false;         ///< it is the one that `LogSource::open` reads
};

/// One transform between frames.
struct LogTransform {
  std::string parent;      ///< frame in which the pose is given
  std::string child;       ///< frame that is placed
  std::string topic;       ///< that states it
  int messages = 0;        ///< those that were looked at
  bool is_static = false;  ///< its topic is for transforms that never change
  bool moves = false;      ///< its poses differ by more than noise
};

/// What a log holds, as far as it can be told without a map.
struct LogContents {
  std::string format;                                        ///< what kind of log it is, in words
  double first_s = 0;                                        ///< when the first message was recorded
  double last_s = 0;                                         ///< when the last one was
  double looked_at_s = 0;                                    ///< lasers, odometry and frames are those up to here
  std::vector<LogTopic> topics;                              ///< by name
  std::vector<LogLaser> lasers;                              ///< by name of their topics
  std::vector<LogCloud> clouds;                              ///< by name of their topics
  std::vector<LogOdometry> odometries;                       ///< by name of their topics
  std::vector<LogTransform> transforms;                      ///< by parent, then child
  std::map<std::string, int> defects;                        ///< what is not whole, and what is odd
  std::vector<std::pair<std::string, std::string>> options;  ///< of the log source, to read the same again
};

}  // namespace opal
