#pragma once

#include "survey/tracking_graph.hpp"

#include <deque>

namespace opal {

/// The poses that the graph holds: as many as it takes to have seen so many different mapped features (thesis 2.4).
/// What falls out leaves a prior on the oldest pose that is left, and remembered offsets.
class TrackingHorizon {
 public:
  TrackingHorizon(const MapView& map, const PoseTrackerOptions& options);

  void start(const PosePrior& prior);
  void forget_offsets();
  /// @param keyframe  the newest; T_before_now is its motion since the one added before.
  void add(TrackedKeyframe keyframe);
  /// Solves for poses and offsets, and writes the offsets to `belief`. @return false if there is no usable solution.
  bool solve(MapBelief& belief);
  /// Drops what is older than the horizon.
  void slide(MapBelief& belief);

  const TrackedKeyframe& newest() const { return keyframes_.back(); }
  const Eigen::Matrix3d& newest_covariance() const { return newest_covariance_; }

 private:
  void thin();
  std::size_t different_features(std::size_t from) const;
  void drop_oldest(MapBelief& belief);

  const PoseTrackerOptions& options_;
  TrackingGraph graph_;
  PosePrior prior_;
  std::deque<TrackedKeyframe> keyframes_;
  std::vector<Eigen::Matrix3d> covariances_;  ///< of the keyframes, as last solved
  OffsetMemories memory_;
  Eigen::Matrix3d newest_covariance_ = Eigen::Matrix3d::Identity();
};

}  // namespace opal
