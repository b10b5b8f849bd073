#pragma once

#include "sensor_health/sensor_monitor.hpp"
#include "sensor_health/wheel_slip.hpp"

#include <opal/sensing/sample.hpp>

#include <memory>
#include <vector>

namespace opal {

/// One monitor a laser.
class OPAL_EXPORT SensorMonitors {
 public:
  /// @param lasers  as described. @param matcher  may be null: then motions are not compared.
  SensorMonitors(const std::vector<LaserModel>& lasers, const std::shared_ptr<const ScanMatcher>& matcher);

  /// Takes every sample, keyframe or not. @return true if the findings changed.
  bool add(const Sample& sample);
  /// A step from keyframe to keyframe. @param by_scans_m  as the scan matcher corrected it.
  void compare_step(double by_odometry_m, double by_scans_m) { slip_.add(by_odometry_m, by_scans_m); }
  void clear();

  /// Laser by laser; of several each finding names its own.
  const std::vector<SensorFinding>& findings() const;
  /// Words of the first finding that contradicts its description; empty if none does.
  std::string contradiction() const;
  /// Odometry stands where the robot does not: its counts do not arrive.
  bool is_odometry_frozen() const;
  /// That, and nothing else contradicts its description.
  bool only_odometry_stands() const;

 private:
  std::vector<LaserModel> lasers_;
  std::vector<SensorMonitor> monitors_;  ///< by laser
  WheelSlip slip_;
  mutable std::vector<SensorFinding> findings_;  ///< of all monitors, as they were asked for last
};

}  // namespace opal
