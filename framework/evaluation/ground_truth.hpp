#pragma once

#include "sensing/trajectory.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal {

/// Recorded truth of a site, for judging results; nothing in the localizer sees it.
class OPAL_EXPORT GroundTruth {
 public:
  GroundTruth() = default;
  /// Reads SITE.gt.csv: `timestamp,x,y,theta,is_scan` with the LASER's pose in the map frame [s, m, m, rad].
  /// @throws LogError naming the file and the line.
  static GroundTruth read(const std::string& path);

  /// Of poses that are known otherwise. @param T_map_laser  by increasing stamp.
  explicit GroundTruth(std::vector<StampedPose> T_map_laser);

  /// Interpolated between neighbouring poses; nullopt outside the recorded time.
  std::optional<Pose2> T_map_laser_at(double stamp_s) const;
  /// Driven from the first pose until then [m], as the poses tell it; those outside the recorded time count as the
  /// nearest.
  double driven_m(double stamp_s) const;
  const std::vector<StampedPose>& poses() const { return poses_; }

 private:
  std::vector<StampedPose> poses_;  ///< by increasing stamp
  std::vector<double> driven_m_;    ///< until each of them
};

}  // namespace opal
