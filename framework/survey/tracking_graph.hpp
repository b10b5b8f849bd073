#pragma once

#include "survey/pose_tracker.hpp"

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace opal {

/// What is known of a pose before the graph is solved.
struct PosePrior {
  Pose2 T_map_base;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of (x, y, heading), map frame
};

/// How far a feature is from where the map has it.
struct FeatureOffset {
  Point moved = Point::Zero();
  double sigma_m = 0;  ///< 0: nothing is known
};

/// What is remembered of offsets from before the horizon.
using OffsetMemories = ListById<MapFeatureNumber, FeatureOffset>;

/// Poses as solved, oldest first, and the offsets of all features that were measured from them.
struct SolvedTrack {
  bool usable = false;
  std::vector<Pose2> T_map_base;
  std::vector<Eigen::Matrix3d> covariances;  ///< per pose, map frame; empty for a batch
  std::map<MapFeatureNumber, FeatureOffset> offsets;
};

/// Told how much of the work that there may be is done; false ends it. Empty: to the end.
using GoesOn = std::function<bool(double share)>;

/// A keyframe of one of several legs.
struct LegPlace {
  std::size_t leg = 0, keyframe = 0;
};

/// A straight face that is not on the map, as one keyframe shows it.
struct LandmarkSight {
  std::size_t landmark = 0;
  Segment seen;                                              ///< base_link frame, the robot on its left
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  ///< (offset at its midpoint, heading) [m, rad]
};

/// A part of a drive that was followed without a break. Its first and last keyframe may be keyframes of other legs once
/// more: that links the legs. If its first is none, nothing but the map links it.
struct TrackLeg {
  std::span<const TrackedKeyframe> track;                 ///< not empty
  Eigen::Vector3d start_sigma = Eigen::Vector3d::Zero();  ///< of its first pose (x, y, heading) [m, m, rad]
  std::optional<LegPlace> begins_at = std::nullopt, ends_at = std::nullopt;
  std::span<const std::vector<LandmarkSight>> landmarks = {};  ///< of each keyframe; empty: none
};

/// Legs as solved together.
struct SolvedLegs {
  bool usable = false;
  std::vector<std::vector<Pose2>> T_map_base;  ///< per leg, per keyframe
  std::map<MapFeatureNumber, FeatureOffset> offsets;
};

/// The factor graph of map-first tracking (Hendrikx 2023, 2.4): poses, linked by odometry and scan matching; measured
/// features, linked to the map through an offset each. Offsets are small or, at a price that hardly grows, large.
class TrackingGraph {
 public:
  TrackingGraph(const MapView& map, const PoseTrackerOptions& options) : map_(map), options_(options) {}

  /// A few poses, solved within a millisecond.
  SolvedTrack solve(std::span<const TrackedKeyframe* const> poses, const PosePrior& oldest,
                    const OffsetMemories& memory) const;
  /// All poses of a track: minutes for thousands of them. Not usable if it was ended.
  SolvedTrack solve_batch(std::span<const TrackedKeyframe> poses, const PosePrior& oldest,
                          const GoesOn& goes_on = {}) const;
  /// Legs of one drive: what is on the map stands at one place, from wherever it is seen. So a pose does not follow a
  /// single face that the map has wrong: all faces along the drive say where it was. Offsets have a sigma_m.
  /// @param landmarks  where faces that are not on the map are thought to be: they link poses, and nothing more.
  SolvedLegs solve_together(std::span<const TrackLeg> legs, std::span<const Segment> landmarks = {}) const;

 private:
  const MapView& map_;
  const PoseTrackerOptions& options_;
};

}  // namespace opal
