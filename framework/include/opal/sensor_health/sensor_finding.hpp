#pragma once

#include <string>

namespace opal {

/// What driving tells of one number of the sensor description.
struct SensorFinding {
  /// What is compared with the description.
  enum class Subject {
    mirroring,          ///< the sense in which the laser's beams turn; found: 1, or -1 if they turn the other way
    mount_heading,      ///< of the laser on the robot [rad]
    mount_position,     ///< distance of the laser from where it is described [m]
    odometry_distance,  ///< metres by scans per metre of odometry
    odometry_turn,      ///< radians by scans per radian of odometry
    standing_odometry,  ///< metres by scans while odometry stands
    no_return,          ///< a range that so many beams have that it is none [m]
    usable_beams        ///< share of the beams that are a hit
  };
  /// How far the description and the drive agree.
  enum class Verdict {
    fine,         ///< they agree as well as one can tell
    doubtful,     ///< they differ, by less than would turn the answer
    contradicted  ///< the description is wrong: no pose that rests on it is called localized
  };
  Subject subject = Subject::mirroring;  ///< what was compared
  Verdict verdict = Verdict::fine;       ///< the result
  double found = 0;                      ///< by driving, in the subject's unit
  double described = 0;                  ///< by the sensor description, in the same unit
  double sigma = 0;                      ///< one-sigma uncertainty of `found`; 0 where it is counted
  std::string words;                     ///< one sentence with the numbers, and what to look at
};

}  // namespace opal
