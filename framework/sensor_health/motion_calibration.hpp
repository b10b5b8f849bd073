#pragma once

#include <opal/common/export.hpp>
#include <opal/common/geometry.hpp>

#include <optional>
#include <span>

namespace opal {

/// One motion of the robot, twice: as odometry has it, and as two scans have it, laid over each other.
struct MotionPair {
  Pose2 T_odometry;                                          ///< of base_link, from its earlier to its later pose
  Pose2 T_scans;                                             ///< of the laser, likewise, in its own frame
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of T_scans (x, y, heading) [m, m, rad]
  bool as_described = true;  ///< the scans lie over each other as odometry and the described mount have it
};

/// A number and its one-sigma uncertainty.
struct Estimated {
  double value = 0;
  double sigma = 0;
};

/// Mount of the laser and scales of the odometry, as a drive shows them.
struct MotionCalibration {
  Estimated turn_scale;      ///< radians by scans per radian of odometry; negative: one of the two is mirrored
  Estimated distance_scale;  ///< metres by scans per metre of odometry
  Estimated mount_heading_rad;
  Point mount_position_m = Point::Zero();  ///< T_base_laser
  double mount_position_sigma_m = 0;       ///< along the worse axis; large if the robot never turned
  double driven_m = 0, turned_rad = 0;     ///< by odometry, over all pairs
  int pairs = 0;
  /// Share of the pairs that agree better with the estimates than with the description: of the turns with the turn
  /// scale, of the distances with mount and distance scale. About a half where the description is right.
  double turns_better = 0, distances_better = 0;
};

/// Robust least squares over pairs of motions (Censi, Franchi, Marchionni, Oriolo 2013, "Simultaneous calibration of
/// odometry and sensor parameters for mobile robots", for poses instead of wheel speeds): the motion of the laser is
/// the motion of the base, seen from its mount. Linear in the scaled rotation and the position of the mount. Pairs
/// count by their covariance, so that a drive along a bare corridor says nothing of distances along it.
/// @param described  the mount where the drive says nothing of it.
/// @return none if the pairs say too little of both turns and distances.
OPAL_EXPORT std::optional<MotionCalibration> calibrate_motion(std::span<const MotionPair> pairs,
                                                              const Pose2& described);

}  // namespace opal
