#pragma once

#include <opal/common/geometry.hpp>

#include <optional>
#include <string>
#include <vector>

namespace opal {

/// How a planar scan is made of a 3D lidar's points: of those between two heights the nearest in each direction.
/// Heights are above the floor, which is z = 0 of the robot's frame.
struct CloudSlice {
  double z_min_m = 0.3;  ///< lower points are not used
  double z_max_m = 1.8;  ///< higher points are not used
  double height_m = 0;   ///< of the sensor above the floor; holds unless the log states the mount, as the angles do
  double roll_rad = 0;   ///< of the sensor about its x axis
  double pitch_rad = 0;  ///< of the sensor about its y axis; positive: it looks down
};

/// What a planar LiDAR can see and where it sits. Comes from the deployment's sensor description.
struct LaserModel {
  std::string id = "PlanarLidar2D";                     ///< the sensor that map features are `perceivable_by`
  std::string frame = {};                               ///< RawScan::frame of its scans; empty: of any
  std::string topic = {};                               ///< where its scans are found, in a log or live; may be empty
  double angle_min_rad = -std::numbers::pi / 2;         ///< bearing of beam 0, in the sensor frame
  double angle_increment_rad = std::numbers::pi / 360;  ///< from one beam to the next; negative: clockwise
  int beams = 361;                                      ///< number of beams in a sweep
  double range_min_m = 0.05;                            ///< nearer returns are invalid
  double range_max_m = 30.0;                            ///< returns farther than this are not used
  double no_return_m = 80.0;                            ///< a range at or above this means that nothing was hit
  double range_sigma_m = 0.02;                          ///< one-sigma noise of a range
  Pose2 T_base_laser;                                   ///< where the sensor sits on the robot
  /// From the first beam of a sweep to the last [s]; 0: all at once. Not given: as the log states it, if it does.
  std::optional<double> sweep_s;
  /// Beam geometry and mount are those that the log states (ROS bags do); what is above holds where it states none.
  bool geometry_from_log = false;
  /// Its scans are slices of point clouds: the beams above are directions, and only the mount may come from the log.
  std::optional<CloudSlice> slice = {};
};

/// What messages call one of a robot's lasers: its frame, or its topic, or its number.
/// @param laser  one of them. @param position  among the robot's lasers, from 0.
OPAL_EXPORT std::string name_of(const LaserModel& laser, std::size_t position);

/// One range reading as recorded; invalid and missing ranges still in it.
struct RawScan {
  double stamp_s = 0;                         ///< by the clock of the log
  std::vector<float> ranges_m;                ///< by beam index; NaN, 0, negative and infinite all occur
  std::string frame;                          ///< the laser's name in the log, as in MountRecord::child; may be empty
  std::optional<Pose2> T_odom_base;           ///< odometry recorded with the scan, if the log has it
  std::optional<double> angle_min_rad;        ///< beam geometry stated by the log itself, if it does
  std::optional<double> angle_increment_rad;  ///< negative: the beams turn clockwise
  double time_increment_s = 0;                ///< from one beam to the next, as the log states it; 0: not stated
  /// Of each beam after the stamp, not negative, where the log states them one by one; else empty.
  std::vector<float> beam_times_s = {};
};

/// One beam that hit something.
struct ScanPoint {
  Point position;          ///< [m] in the sensor frame
  double range_m = 0;      ///< distance from the sensor
  double bearing_rad = 0;  ///< in the sensor frame, in [-pi, pi)
  int beam = 0;            ///< index in the sweep as recorded
};

/// One sweep, cleaned: points by increasing bearing in the sensor frame (`laser`). Bearings are in [-pi, pi), so the
/// points of a laser that sees all around start and end behind it, whatever beam it starts with.
struct Scan {
  double stamp_s = 0;                     ///< by the clock of the log
  double angle_increment_rad = 0;         ///< positive
  double range_max_m = 0;                 ///< of the laser model: hits are no farther
  std::vector<ScanPoint> points;          ///< valid returns up to range_max_m
  std::vector<double> free_bearings_rad;  ///< beams that hit nothing up to range_max_m, increasing
  int invalid = 0;                        ///< NaN, zero, negative or too near: neither hit nor free
};

/// Whether a recorded range lies below a limit. Logs hold ranges in single precision, or as text of a few digits: what
/// rounds to the limit, to the millimetre, is not below it.
OPAL_EXPORT bool is_below(double range_m, double limit_m);

/// Cleans one reading. A return farther than range_max_m leaves the beam free up to there, as no return does.
/// Beams that the model does not describe are ignored and counted as invalid.
OPAL_EXPORT Scan make_scan(const RawScan& raw, const LaserModel& laser);

}  // namespace opal
