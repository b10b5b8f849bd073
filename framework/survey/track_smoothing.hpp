#pragma once

#include "sensing/trajectory.hpp"
#include "survey/pose_tracker.hpp"
#include "survey/tracking_graph.hpp"

#include <optional>
#include <span>
#include <vector>

namespace opal {

/// A track as all of its measurements tell it, those that came later, too.
struct SmoothedTrack {
  std::vector<Pose2> T_map_base;  ///< one per keyframe of the track
  MapBelief belief;               ///< offsets from the whole track; what was counted while driving is kept
};

/// Offline mode (Hendrikx 2023, appendix B): one factor graph over a whole track.
/// @param start_sigma  one-sigma uncertainty of the first pose (x, y, heading) [m, m, rad].
/// @param belief  as the tracker left it.
/// @return nullopt if `goes_on` ended it; an empty track stays empty.
/// @throws Error if the graph has no usable solution.
OPAL_EXPORT std::optional<SmoothedTrack> smooth_track(const MapView& map, std::span<const TrackedKeyframe> track,
                                                      const Eigen::Vector3d& start_sigma, MapBelief belief,
                                                      const PoseTrackerOptions& options = {},
                                                      const GoesOn& goes_on = {});

/// A trajectory that was recorded while tracking, corrected by what smoothing changed at the keyframes: the correction
/// in between is shared out by time. Poses before the first keyframe are left out.
/// @param tracked  by increasing stamp, T_map_base.
OPAL_EXPORT std::vector<StampedPose> corrected_trajectory(std::span<const StampedPose> tracked,
                                                          std::span<const TrackedKeyframe> track,
                                                          const SmoothedTrack& smoothed);

}  // namespace opal
