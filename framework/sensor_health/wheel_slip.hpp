#pragma once

#include <opal/common/export.hpp>
#include <opal/sensor_health/sensor_finding.hpp>

#include <deque>
#include <optional>

namespace opal {

/// Holds what odometry counts against what the scan matcher sees, over the last metres. A description that is wrong
/// all the time is the monitor's to find; this notices wheels that slip for a while.
class OPAL_EXPORT WheelSlip {
 public:
  /// One step from keyframe to keyframe. @param by_scans_m  as the scan matcher corrected it.
  void add(double by_odometry_m, double by_scans_m);
  void clear();
  /// Nothing while both agree.
  std::optional<SensorFinding> finding() const;

 private:
  struct Step {
    double by_odometry_m, by_scans_m;
  };
  std::deque<Step> steps_;
  Step sum_{0, 0};
};

}  // namespace opal
