#pragma once

#include <opal/common/geometry.hpp>

#include <limits>

namespace opal {

/// Which scans of a robot at rest are looked at, though nothing has moved. Odometry often tells of a motion later than
/// scans do: on recorded logs by up to 0.2 s, ten degrees at the end of a turn. A robot at rest would keep that error.
class OPAL_EXPORT Settling {
 public:
  /// @param T_odom_base  at each scan, by increasing time.
  /// @return the scan is one to look at: a few after each stop, the later the rarer, since all of them see the same.
  bool add(double stamp_s, const Pose2& T_odom_base);

 private:
  double rest_s_ = std::numeric_limits<double>::infinity();  ///< of the scan since which nothing has moved
  Pose2 T_odom_rest_;                                        ///< then
  int looks_ = 0;                                            ///< since then
};

}  // namespace opal
