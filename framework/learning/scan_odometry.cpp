#include "learning/scan_odometry.hpp"

#include "local_map/local_map_odometry.hpp"
#include "survey/fused_motion.hpp"

namespace opal {

std::vector<TrackedKeyframe> scan_odometry(const LocalizerParts& parts, std::span<const Sample> samples,
                                           const Pose2& start) {
  LocalMapOptions options = parts.local_map;
  options.optimize_every = 0;
  LocalMap local_map(options, parts.matcher);
  std::vector<TrackedKeyframe> track;
  for (const Sample& sample : samples) {
    const Pose2 T_local_before = local_map.T_local_base();
    const Pose2 driven = T_local_before.inverse() * local_map.T_local_base_at(sample.T_odom_base);
    local_map.add(sample, {});
    TrackedKeyframe keyframe;
    keyframe.stamp_s = sample.stamp_s;
    keyframe.T_map_base = start;
    if (!track.empty()) {
      Motion motion{driven, odometry_sigma(driven, parts.local_map).cwiseAbs2().asDiagonal()};
      if (local_map.last_match().converged)
        motion = fused(motion, {T_local_before.inverse() * local_map.T_local_base(),
                                turned(local_map.last_match().covariance, T_local_before.inverse())});
      keyframe.T_before_now = motion.T_before_now;
      keyframe.motion_covariance = motion.covariance;
      keyframe.T_map_base = track.back().T_map_base * motion.T_before_now;
    }
    track.push_back(std::move(keyframe));
  }
  return track;
}

}  // namespace opal
