#pragma once

#include <opal/trajectory.hpp>

#include <optional>
#include <string>
#include <vector>

namespace opal {

/// Recorded truth of a site, for judging results; nothing in the localizer sees it.
class OPAL_EXPORT GroundTruth {
 public:
  /// Reads SITE.gt.csv: `timestamp,x,y,theta,is_scan` with the LASER's pose in the map frame [s, m, m, rad].
  /// @throws LogError naming the file and the line.
  static GroundTruth read(const std::string& path);

  /// Interpolated between neighbouring poses; nullopt outside the recorded time.
  std::optional<Pose2> T_map_laser_at(double stamp_s) const;
  const std::vector<StampedPose>& poses() const { return poses_; }

 private:
  std::vector<StampedPose> poses_;  ///< by increasing stamp
};

}  // namespace opal
