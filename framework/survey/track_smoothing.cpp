#include "survey/track_smoothing.hpp"

#include <opal/common/error.hpp>

#include "survey/tracking_graph.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace opal {
namespace {

Pose2 part_of(const Pose2& motion, double share) {
  return {Point(share * motion.position()), share * motion.heading_rad()};
}

}  // namespace

std::optional<SmoothedTrack> smooth_track(const MapView& map, std::span<const TrackedKeyframe> track,
                                          const Eigen::Vector3d& start_sigma, MapBelief belief,
                                          const PoseTrackerOptions& options, const GoesOn& goes_on) {
  SmoothedTrack smoothed;
  smoothed.belief = std::move(belief);
  if (track.empty()) return smoothed;
  bool is_ended = false;
  const GoesOn asking = [&](double share) { return !(is_ended = goes_on && !goes_on(share)); };
  const PosePrior start{track.front().T_map_base, start_sigma.cwiseAbs2().asDiagonal()};
  SolvedTrack solved = TrackingGraph(map, options).solve_batch(track, start, asking);
  if (is_ended) return std::nullopt;
  if (!solved.usable)
    throw Error(fmt::format("smoothing: the factor graph of {} poses has no usable solution", track.size()));
  smoothed.T_map_base = std::move(solved.T_map_base);
  for (const auto& [feature, offset] : solved.offsets) smoothed.belief[feature].moved = offset.moved;
  return smoothed;
}

std::vector<StampedPose> corrected_trajectory(std::span<const StampedPose> tracked,
                                              std::span<const TrackedKeyframe> track, const SmoothedTrack& smoothed) {
  std::vector<StampedPose> corrected;
  std::size_t k = 0;  // newest keyframe that is not newer than the pose
  for (const StampedPose& pose : tracked) {
    if (track.empty() || pose.stamp_s < track.front().stamp_s) continue;
    while (k + 1 < track.size() && track[k + 1].stamp_s <= pose.stamp_s) ++k;
    const Pose2 T_keyframe_pose = track[k].T_map_base.inverse() * pose.pose;
    Pose2 T_map_base = smoothed.T_map_base[k] * T_keyframe_pose;
    if (k + 1 < track.size()) {
      const double share = (pose.stamp_s - track[k].stamp_s) / (track[k + 1].stamp_s - track[k].stamp_s);
      const Pose2 T_map_next = smoothed.T_map_base[k] * track[k + 1].T_before_now;
      T_map_base = T_map_base * part_of(T_map_next.inverse() * smoothed.T_map_base[k + 1], share);
    }
    corrected.push_back({pose.stamp_s, T_map_base});
  }
  return corrected;
}

}  // namespace opal
