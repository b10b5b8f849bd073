#pragma once

#include <opal/common/geometry.hpp>

#include <iosfwd>
#include <optional>
#include <span>

namespace opal {

struct StampedPose {
  double stamp_s = 0;
  Pose2 pose;  ///< in whatever frame the trajectory is in
};

/// Writes `timestamp tx ty tz qx qy qz qw` per line [s, m], as the TUM RGB-D benchmark's tools read it. What is not
/// finite is left out.
OPAL_EXPORT void write_tum(std::ostream& out, std::span<const StampedPose> trajectory);

/// Interpolated between neighbouring poses; nullopt outside the time of the poses, which stand by increasing stamp.
OPAL_EXPORT std::optional<Pose2> pose_at(std::span<const StampedPose> poses, double stamp_s);

}  // namespace opal
