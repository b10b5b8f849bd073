#pragma once

#include "sensor_health/motion_pairs.hpp"
#include "sensor_health/range_habits.hpp"
#include "sensor_health/standing_odometry.hpp"

#include <opal/sensor_health/sensor_finding.hpp>

#include <optional>
#include <vector>

namespace opal {

/// Holds the sensor description against the drive: motion by scans against motion by odometry, ranges against limits.
/// It knows neither the map nor where the robot is. Its judgement rests on the newest motions, so that it recovers from
/// wheels that slipped, and from a robot that was carried.
class OPAL_EXPORT SensorMonitor {
 public:
  /// @param described  the sensor. @param matcher  may be null: then motions are not compared.
  SensorMonitor(const LaserModel& described, std::shared_ptr<const ScanMatcher> matcher);

  /// Takes every scan, keyframe or not.
  /// @param scan  sensor frame. @param T_odom_base  odometry at its stamp.
  /// @return true if the findings changed.
  bool add(const Scan& scan, const Pose2& T_odom_base);
  void clear();

  /// By subject; those of which the drive has told enough.
  const std::vector<SensorFinding>& findings() const { return findings_; }

 private:
  void take(const MotionPair& pair, double stamp_s);
  /// @return false: the robot stands where the last one was taken.
  bool look_at_ranges(const Scan& scan, const Pose2& T_odom_base);
  void judge_motions();
  /// Most beams have changed while odometry stood, and it is no crowd that walks about a robot that stands.
  bool is_odometry_frozen(double stamp_s) const;

  LaserModel described_;
  std::optional<MotionPairs> motions_;
  std::vector<MotionPair> newest_;    ///< motions of the odometry
  std::vector<MotionPair> standing_;  ///< motions that odometry has none of
  RangeHabits ranges_;
  StandingOdometry frozen_;
  bool was_frozen_ = false;                ///< at the newest scan
  std::optional<double> still_stamp_s_;    ///< when scans last said that the robot stands
  std::optional<Pose2> T_odom_ranges_;     ///< where ranges were looked at last
  std::vector<SensorFinding> of_motions_;  ///< as the newest motion left them
  std::vector<SensorFinding> findings_;
};

}  // namespace opal
