#include "survey/tracking_horizon.hpp"

#include "local_map/graph_factors.hpp"

#include <algorithm>
#include <set>

namespace opal {
namespace {

// A pose that became the oldest one is known from what was dropped, but not better than this: what is left of its
// measurements must not count twice without bound.
constexpr double kLeastPriorSigma_m = 0.05, kLeastPriorSigma_rad = 0.02;

/// What was counted where the feature is not, is forgotten.
void update(FeatureBelief& belief, const FeatureOffset& offset) {
  constexpr double kElsewhere_m = 0.15;
  if ((offset.moved - belief.moved).norm() > kElsewhere_m) belief.seen = belief.seen_through = 0;
  belief.moved = offset.moved;
  belief.sigma_m = offset.sigma_m;
}

}  // namespace

TrackingHorizon::TrackingHorizon(const MapView& map, const PoseTrackerOptions& options)
    : options_(options), graph_(map, options), memory_(map.map().features().size()) {}

void TrackingHorizon::start(const PosePrior& prior) {
  prior_ = prior;
  newest_covariance_ = prior.covariance;
  keyframes_.clear();
  covariances_.clear();
}

void TrackingHorizon::forget_offsets() { memory_.assign(memory_.size(), {}); }

void TrackingHorizon::add(TrackedKeyframe keyframe) {
  keyframes_.push_back(std::move(keyframe));
  thin();
}

/// The newest but one goes if it differs little from the one before it.
void TrackingHorizon::thin() {
  const std::size_t n = keyframes_.size();
  if (n < 3) return;
  const TrackedKeyframe &before = keyframes_[n - 3], &middle = keyframes_[n - 2];
  TrackedKeyframe& newest = keyframes_[n - 1];
  if (distance_m(before.T_map_base, middle.T_map_base) >= options_.pose_spacing_m ||
      angle_between_rad(before.T_map_base, middle.T_map_base) >= options_.pose_spacing_rad)
    return;
  const RelativePose first{{}, {}, middle.T_before_now, middle.motion_covariance};
  const RelativePose second{{}, {}, newest.T_before_now, newest.motion_covariance};
  newest.motion_covariance = chained(first, second);
  newest.T_before_now = first.T_from_to * second.T_from_to;
  keyframes_.erase(keyframes_.end() - 2);
}

bool TrackingHorizon::solve(MapBelief& belief) {
  std::vector<const TrackedKeyframe*> poses;
  for (const TrackedKeyframe& keyframe : keyframes_) poses.push_back(&keyframe);
  const SolvedTrack track = graph_.solve(poses, prior_, memory_);
  if (!track.usable) return false;
  for (std::size_t k = 0; k < keyframes_.size(); ++k) keyframes_[k].T_map_base = track.T_map_base[k];
  covariances_ = track.covariances;
  newest_covariance_ = covariances_.back();
  for (const auto& [feature, offset] : track.offsets) update(belief[feature], offset);
  return true;
}

std::size_t TrackingHorizon::different_features(std::size_t from) const {
  std::set<MapFeatureNumber> features;
  for (std::size_t k = from; k < keyframes_.size(); ++k)
    for (const MapMeasurement& measured : keyframes_[k].measurements) features.insert(measured.feature);
  return features.size();
}

void TrackingHorizon::slide(MapBelief& belief) {
  const auto least = static_cast<std::size_t>(options_.horizon_least_poses);
  const auto most = static_cast<std::size_t>(options_.horizon_most_poses);
  while (keyframes_.size() > least &&
         (keyframes_.size() > most || different_features(1) >= static_cast<std::size_t>(options_.horizon_features)))
    drop_oldest(belief);
}

void TrackingHorizon::drop_oldest(MapBelief& belief) {
  for (const MapMeasurement& measured : keyframes_.front().measurements) {
    const FeatureBelief& known = belief[measured.feature];
    memory_[measured.feature] = {known.moved, std::max(options_.offset_memory_m, known.sigma_m)};
  }
  keyframes_.pop_front();
  prior_.T_map_base = keyframes_.front().T_map_base;
  if (covariances_.size() > 1) {
    covariances_.erase(covariances_.begin());
    prior_.covariance = covariances_.front();
  }
  prior_.covariance.diagonal() +=
      Eigen::Vector3d(kLeastPriorSigma_m, kLeastPriorSigma_m, kLeastPriorSigma_rad).cwiseAbs2();
}

}  // namespace opal
