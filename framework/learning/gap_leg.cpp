#include "learning/gap_leg.hpp"

#include "learning/followed_leg.hpp"
#include "survey/fused_motion.hpp"

namespace opal {
namespace {

/// The motion along samples as odometry and scan matching tell it, without a map: one keyframe per sample, the first of
/// which stands at `start`. Nothing is measured yet.
/// @param samples  in time order.
std::vector<TrackedKeyframe> scan_odometry(const LocalizerParts& parts, std::span<const Sample> samples,
                                           const Pose2& start) {
  LocalMapOptions options = parts.local_map;
  options.optimize_every = 0;
  LocalMap local_map(options, parts.matcher);
  std::vector<TrackedKeyframe> track;
  for (const Sample& sample : samples) {
    const Motion motion = next_motion(local_map, sample, parts.local_map).fused;
    TrackedKeyframe keyframe;
    keyframe.stamp_s = sample.stamp_s;
    keyframe.T_map_base = start;
    if (!track.empty()) {
      keyframe.T_before_now = motion.T_before_now;
      keyframe.motion_covariance = motion.covariance;
      keyframe.T_map_base = track.back().T_map_base * motion.T_before_now;
    }
    track.push_back(std::move(keyframe));
  }
  return track;
}

/// Shares out, along a track, what its end is away from where it should be. @return false if that is too far.
bool close(std::vector<TrackedKeyframe>& track, const Pose2& end) {
  constexpr double kWay = 0.05, kLeast_m = 0.5, kMost_rad = 0.3;
  double way_m = 0;
  for (const TrackedKeyframe& keyframe : track) way_m += distance_m(Pose2(), keyframe.T_before_now);
  const Pose2& found = track.back().T_map_base;
  if (distance_m(found, end) > kLeast_m + kWay * way_m || angle_between_rad(found, end) > kMost_rad) return false;
  const Point off = end.position() - found.position();
  const double turn = wrap_angle(end.heading_rad() - found.heading_rad());
  for (std::size_t k = 0; k < track.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(track.size() - 1);
    Pose2& pose = track[k].T_map_base;
    pose = Pose2(Point(pose.position() + share * off), pose.heading_rad() + share * turn);
  }
  return true;
}

}  // namespace

std::optional<DriveLeg> gap_leg(const LocalizerParts& parts, std::span<const Sample> samples, const Pose2& start,
                                const Pose2& end) {
  DriveLeg gap;
  gap.track = scan_odometry(parts, samples, start);
  if (!close(gap.track, end)) return std::nullopt;
  for (const Sample& sample : samples) gap.views.push_back(view_of(sample));
  gap.visits = {samples.size()};
  gap.is_gap = true;
  return gap;
}

}  // namespace opal
