#pragma once

#include "sensor_health/motion_calibration.hpp"
#include "sensor_health/range_habits.hpp"

#include <opal/sensor_health/sensor_finding.hpp>

#include <span>
#include <vector>

namespace opal {

/// One-sigma up to which a drive tells a number of the description; what it tells worse, nothing is said of.
struct ToldWithin {
  static constexpr double heading_rad = 0.06, position_m = 0.1, scale = 0.08;
};

/// What a calibration says of a description, subject by subject; subjects that are not known well enough are left out.
OPAL_EXPORT std::vector<SensorFinding> judge_motion(const MotionCalibration& drive, const Pose2& T_base_laser);

/// Whether scans lie over each other as those of a robot that stands; people in them do not move all of it.
OPAL_EXPORT bool is_still_by_scans(const MotionPair& pair);

/// What scans say of a robot that stands, by its odometry.
/// @param standing  the newest motions without odometry.
OPAL_EXPORT std::vector<SensorFinding> judge_standing(std::span<const MotionPair> standing);

/// Odometry has frozen. @param changed_share  of the beams while it stood.
SensorFinding frozen_odometry(double changed_share);

/// What ranges say of the limits of a description.
OPAL_EXPORT std::vector<SensorFinding> judge_ranges(const RangeHabits& habits, const LaserModel& described);

}  // namespace opal
