#pragma once

#include <opal/localization/localizer.hpp>
#include "survey/map_belief.hpp"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace opal {

struct PoseTrackerOptions {
  double view_m = 15;              ///< mapped features farther from the robot are not looked for
  double wall_error_m = 0.8;       ///< mapped features may be off by this much, and no more
  double offset_scale_m = 0.06;    ///< mapped features are off by about this much; a few of them by much more
  double offset_memory_m = 0.1;    ///< least one-sigma with which an offset is remembered once it is out of the horizon
  int horizon_features = 12;       ///< the horizon keeps so many different mapped features (thesis 2.4),
  int horizon_least_poses = 4;     ///< at least so many poses,
  int horizon_most_poses = 10;     ///< at most so many,
  double pose_spacing_m = 0.25;    ///< which differ by this distance
  double pose_spacing_rad = 0.25;  ///< or this angle
  int features_per_scan = 24;      ///< the best seen ones are used
  double robust_scale = 1.5;       ///< Cauchy loss of measurements, in standard deviations
  double lost_after_m = 3;         ///< driving over which it is judged whether scans fit the map
};

/// Where the robot is, and how well the scan fits there.
struct TrackedPose {
  double stamp_s = 0;
  Pose2 T_map_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, heading) in the map frame [m, m, rad]
  double on_map_share = 0;   ///< of the scan's points that lie on a mapped feature, in [0, 1]
  double through_share = 0;  ///< of its beams that passed through a mapped feature, in [0, 1]
  int features = 0;          ///< mapped features recognized in this scan
  bool lost = false;         ///< lately, more beams have passed through mapped features than have ended on one
};

/// A mapped feature as one scan shows it.
struct MapMeasurement {
  MapFeatureNumber feature = {};
  Geometry seen;  ///< base_link frame, of the mapped feature's kind
  Eigen::Matrix2d covariance =
      Eigen::Matrix2d::Identity();  ///< segments: (offset, heading) [m, rad]; others: (x, y) [m]
};

/// One pose of a finished track with what was recognized from it, for smoothing.
struct TrackedKeyframe {
  double stamp_s = 0;
  Pose2 T_map_base;
  Pose2 T_before_now;  ///< motion since the keyframe before, as odometry and scan matching measured it
  Eigen::Matrix3d motion_covariance = Eigen::Matrix3d::Identity();  ///< in the frame of the keyframe before
  std::vector<MapMeasurement> measurements;
};

/// Follows a pose that is known at the start (Hendrikx 2023, chapter 2). Map first: the features that the map holds
/// near the predicted pose are looked for in the scan, and what is found becomes factors between the poses of a short
/// horizon and the map. What the map does not hold is not looked for, so people and furniture do not matter. Every
/// mapped feature has an offset of its own that is estimated along with the poses: the map may be wrong.
///
/// Use it when the pose is known and only to be kept (docking, truth for experiments, checking a building against its
/// model); use Localizer when it is not. One object per robot, called in time order from one thread.
class OPAL_EXPORT PoseTracker {
 public:
  /// Of the parts, it uses map, keyframes, local map (odometry errors), matcher and detectors.
  /// @throws ConfigError if there is no map.
  explicit PoseTracker(LocalizerParts parts, PoseTrackerOptions options = {});
  ~PoseTracker();

  /// Begins at a pose; what was learned about the map is kept. The next scan is the first one.
  /// @param sigma  one-sigma uncertainty of the pose (x, y, heading) [m, m, rad].
  /// @throws ConfigError if the pose is not finite, or farther than 30 m from everything on the map.
  void start(const Pose2& T_map_base, const Eigen::Vector3d& sigma);
  /// Believes the map again.
  void forget_offsets();

  /// Takes what the lasers saw at one time; poor scans are bridged by odometry. Samples before `start` are not taken.
  /// The first scan of a sample places the robot, and all of them measure the map.
  /// @return the pose if the sample became a keyframe, else nullopt.
  std::optional<TrackedPose> update(const Sample& sample);
  /// The newest pose carried on by odometry.
  Pose2 T_map_base_at(const Pose2& T_odom_base) const;

  const TrackedPose& last() const;
  const MapView& map() const;
  const MapBelief& belief() const;
  /// All keyframes since `start`, oldest first, each as it was estimated when it was the newest.
  const std::vector<TrackedKeyframe>& track() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace opal
