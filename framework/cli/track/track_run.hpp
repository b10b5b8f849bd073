#pragma once

#include <opal/sensing/replay.hpp>
#include "evaluation/ground_truth.hpp"
#include "evaluation/results.hpp"
#include "sensing/trajectory.hpp"
#include "survey/pose_tracker.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace opal::cli {

/// Where a track begins.
struct StartPose {
  Pose2 T_map_base;
  Eigen::Vector3d sigma = Eigen::Vector3d::Zero();  ///< one-sigma (x, y, heading) [m, m, rad]
};
/// The pose of the first scan, asked by its stamp; nullopt: not known for this one, ask for the next.
using StartAt = std::function<std::optional<StartPose>(double stamp_s)>;

/// One window of a log, tracked from a given pose.
struct TrackedWindow {
  std::string id;
  std::vector<ResultRow> rows;           ///< one per scan
  std::vector<ResultRow> dead_reckoned;  ///< the same scans from the same pose by odometry alone
  std::vector<StampedPose> trajectory;   ///< T_map_base, the same scans
  std::vector<double> update_cpu_ms;     ///< per keyframe, cleaning of the scan included
  std::vector<TrackedKeyframe> track;
  std::vector<Point> last_points;  ///< of the last scan, map frame [m]
  TrackedPose last;
  bool is_cut = false;  ///< a stop was asked for before its end
};

/// Plays a window through a tracker that starts anew. @param stop  ends it before its end.
TrackedWindow track_window(PoseTracker& tracker, const LaserModel& laser, Replay& replay, const std::string& id,
                           const StartAt& start_at, const std::stop_token& stop = {});

/// Position errors against recorded truth [m], over the scans for which there is some.
struct TrackErrors {
  std::size_t scans = 0;
  double max_m = 0, p95_m = 0, median_m = 0;
};
TrackErrors errors_of(const std::vector<ResultRow>& rows, const GroundTruth& truth);

}  // namespace opal::cli
