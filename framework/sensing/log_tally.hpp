#pragma once

#include <opal/sensing/log_source.hpp>

namespace opal {

/// Rate and pauses of a topic, from the times of its messages. They may come in any order.
class OPAL_EXPORT StampTally {
 public:
  void add(double stamp_s) { stamps_s_.push_back(stamp_s); }
  /// Fills all but name and type.
  void tell(LogTopic& topic) const;

 private:
  std::vector<double> stamps_s_;
};

/// What a laser's scans have in common.
class OPAL_EXPORT LaserTally {
 public:
  void add(const RawScan& scan);
  /// Fills what scans tell; the rest is left as it is.
  void tell(LogLaser& laser) const;

 private:
  void add_range(float range_m);

  std::map<int, int> scans_by_beams_;
  std::optional<RawScan> first_;
  double readings_ = 0, no_returns_ = 0, invalid_ = 0;
  float nearest_m_ = 0, farthest_m_ = 0, second_farthest_m_ = 0;
  double at_farthest_ = 0;  // readings that are the farthest of all, to the last bit
};

/// How far odometry says the robot has driven.
class OPAL_EXPORT OdometryTally {
 public:
  void add(const Pose2& T_odom_base);
  /// Fills poses, path and turns; the rest is left as it is.
  void tell(LogOdometry& odometry) const;

 private:
  std::optional<Pose2> last_;
  int poses_ = 0;
  double driven_m_ = 0, turned_rad_ = 0;
};

}  // namespace opal
