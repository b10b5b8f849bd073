#include <opal/local_map/local_map.hpp>

#include "common/covariance.hpp"
#include "local_map/local_map_association.hpp"
#include "local_map/local_map_graph.hpp"
#include "local_map/local_map_horizon.hpp"
#include "local_map/local_map_merging.hpp"
#include "local_map/local_map_odometry.hpp"
#include "local_map/matched_points.hpp"
#include "sensing/finite_geometry.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <optional>

namespace opal {
namespace {

constexpr double kShortestSegment_m = 1e-3;

// A pose farther out than this is damage, not driving; it would also spoil the arithmetic.
constexpr double kFarthest_m = 1e7;

bool is_usable(const Pose2& pose) {
  return pose.position().cwiseAbs().maxCoeff() < kFarthest_m && pose.position().allFinite() &&
         std::isfinite(pose.heading_rad());
}

bool is_usable(const Feature& feature) {
  const auto* segment = std::get_if<Segment>(&feature.geometry);
  return feature.covariance.allFinite() && std::isfinite(feature.support_m) && is_finite(feature.geometry) &&
         (!segment || segment->length_m() > kShortestSegment_m);
}

/// The feature with a covariance that is one: symmetric, without negative variances.
Feature with_sound_covariance(Feature feature) {
  Eigen::Matrix3d& c = feature.covariance;
  c = (0.5 * (c + c.transpose())).eval();
  const Eigen::Matrix3d padded = c + 1e-9 * Eigen::Matrix3d::Identity();
  if (padded.llt().info() != Eigen::Success) c = c.diagonal().cwiseAbs().eval().asDiagonal();
  return feature;
}

}  // namespace

struct LocalMap::State {
  LocalMapOptions options;
  std::shared_ptr<const ScanMatcher> matcher;
  std::vector<LocalFeature> features;
  std::deque<Keyframe> keyframes;
  std::vector<RelativePose> motions;  ///< motions[i].to is a keyframe, increasing
  std::vector<LocalFeatureId> associations;
  ScanMatch last_match;
  Pose2 T_local_base;
  std::optional<Pose2> T_odom_base;  ///< last usable reading
  LocalFeatureId next_feature_id{0};
  KeyframeId next_keyframe_id{0};
  int not_optimized = 0;

  Pose2 predict(const Pose2& T_odom_now) const;
  Pose2 improve(const Pose2& predicted, const std::vector<Point>& points);
  void append_keyframe(Keyframe keyframe, bool superseding);
  RelativePose motion_to_newest(const Keyframe& from) const;
  void take_in(const std::vector<Feature>& detected);
  void measure(int index, const Feature& in_base, LocalFeatureId& id);
  void estimate_newly_seen();
  void forget_old(bool superseded);
  void optimize();
};

/// Algorithm 1, line 1. Before the first reading there is nothing to compare with.
Pose2 LocalMap::State::predict(const Pose2& T_odom_now) const {
  if (!T_odom_base || !is_usable(T_odom_now)) return T_local_base;
  return T_local_base * (T_odom_base->inverse() * T_odom_now);
}

/// The predicted pose laid over the points seen lately, as far as they tell (thesis A.1.2).
Pose2 LocalMap::State::improve(const Pose2& predicted, const std::vector<Point>& points) {
  const Eigen::Vector3d sigma = odometry_sigma(T_local_base.inverse() * predicted, options);
  ScanMatch by_odometry;
  by_odometry.T_reference_scan = predicted;
  by_odometry.covariance = sigma.cwiseAbs2().asDiagonal();
  last_match = by_odometry;
  if (!matcher || keyframes.empty() || points.empty()) return predicted;
  const ScanMatch match = matcher->match(matched_points(predicted.position(), keyframes), points, predicted, sigma);
  if (match.converged && is_usable(match.T_reference_scan)) last_match = match;
  last_match.inlier_share = match.inlier_share;
  return last_match.T_reference_scan;
}

/// The newest keyframe's way is measured from the one that stays before it.
void LocalMap::State::append_keyframe(Keyframe keyframe, bool superseding) {
  keyframe.id = next_keyframe_id;
  next_keyframe_id = next_keyframe_id.next();
  keyframe.T_odom_base = T_odom_base.value_or(Pose2());
  T_local_base = keyframe.T_local_base;
  keyframes.push_back(std::move(keyframe));
  const std::size_t back = superseding ? 3 : 2;
  if (keyframes.size() < back) return;
  const Keyframe& before = keyframes[keyframes.size() - back];
  keyframes.back().driven_m = before.driven_m + driven_between_m(before.T_local_base, T_local_base, options);
  if (superseding) motions.pop_back();
  motions.push_back(motion_to_newest(before));
}

RelativePose LocalMap::State::motion_to_newest(const Keyframe& from) const {
  const Keyframe& to = keyframes.back();
  RelativePose motion{from.id, to.id, from.T_local_base.inverse() * to.T_local_base, {}};
  if (last_match.converged) {
    motion.covariance = turned_covariance(from.T_local_base.inverse(), last_match.covariance);
  } else {
    motion.covariance = odometry_sigma(motion.T_from_to, options).cwiseAbs2().asDiagonal();
  }
  return motion;
}

/// Algorithm 1, lines 3 to 21: each detection joins a local feature or begins one.
void LocalMap::State::take_in(const std::vector<Feature>& detected) {
  associations.assign(detected.size(), LocalFeatureId());
  std::vector<std::size_t> usable;
  std::vector<Feature> in_base, in_local;
  for (std::size_t i = 0; i < detected.size(); ++i) {
    if (!is_usable(detected[i])) continue;
    usable.push_back(i);
    in_base.push_back(with_sound_covariance(detected[i]));
    in_local.push_back(transformed(T_local_base, in_base.back()));
  }
  const std::vector<int> partners = associate(in_local, features, options);
  for (std::size_t k = 0; k < usable.size(); ++k) measure(partners[k], in_base[k], associations[usable[k]]);
  estimate_newly_seen();
  merge_pieces(features, associations, keyframes, options);
}

void LocalMap::State::measure(int index, const Feature& in_base, LocalFeatureId& id) {
  if (index < 0) {
    index = static_cast<int>(features.size());
    features.emplace_back().id = next_feature_id;
    next_feature_id = next_feature_id.next();
  }
  LocalFeature& local = features[static_cast<std::size_t>(index)];
  local.measurements.push_back({keyframes.back().id, in_base});
  id = local.id;
}

void LocalMap::State::estimate_newly_seen() {
  for (LocalFeature& local : features)
    if (local.measurements.back().keyframe == keyframes.back().id) refresh(local, keyframes, options);
}

void LocalMap::State::forget_old(bool superseded) {
  forget(keyframes, features, superseded, options);
  const KeyframeId oldest = keyframes.front().id;
  std::erase_if(motions, [&](const RelativePose& motion) { return motion.from < oldest; });
}

void LocalMap::State::optimize() {
  if (options.optimize_every <= 0 || ++not_optimized < options.optimize_every) return;
  not_optimized = 0;
  if (!optimize_poses(keyframes, features, motions, options)) return;
  T_local_base = keyframes.back().T_local_base;
  for (LocalFeature& local : features) refresh(local, keyframes, options);
}

LocalMap::LocalMap(LocalMapOptions options, std::shared_ptr<const ScanMatcher> matcher)
    : state_(std::make_unique<State>()) {
  state_->options = options;
  state_->matcher = std::move(matcher);
}
LocalMap::~LocalMap() = default;
LocalMap::LocalMap(LocalMap&&) noexcept = default;
LocalMap& LocalMap::operator=(LocalMap&&) noexcept = default;

void LocalMap::add(const Sample& sample, const std::vector<Feature>& features) {
  State& s = *state_;
  const bool superseding = !newest_is_distinct(s.keyframes, s.options);
  Keyframe keyframe;
  keyframe.stamp_s = sample.stamp_s;
  keyframe.points = points_in_base(sample);
  keyframe.T_local_base = s.improve(s.predict(sample.T_odom_base), keyframe.points);
  if (is_usable(sample.T_odom_base)) s.T_odom_base = sample.T_odom_base;
  s.append_keyframe(std::move(keyframe), superseding);
  s.take_in(features);
  s.forget_old(superseding);
  s.optimize();
}

void LocalMap::clear() {
  State fresh;
  fresh.options = state_->options;
  fresh.matcher = state_->matcher;
  fresh.next_feature_id = state_->next_feature_id;
  fresh.next_keyframe_id = state_->next_keyframe_id;
  *state_ = std::move(fresh);
}

void LocalMap::keep_only(const std::vector<LocalFeatureId>& ids) {
  std::erase_if(state_->features,
                [&](const LocalFeature& local) { return std::find(ids.begin(), ids.end(), local.id) == ids.end(); });
}

const std::vector<LocalFeature>& LocalMap::features() const { return state_->features; }
const std::deque<Keyframe>& LocalMap::keyframes() const { return state_->keyframes; }
const Pose2& LocalMap::T_local_base() const { return state_->T_local_base; }
Pose2 LocalMap::T_local_base_at(const Pose2& T_odom_base) const { return state_->predict(T_odom_base); }
const std::vector<LocalFeatureId>& LocalMap::last_associations() const { return state_->associations; }
const ScanMatch& LocalMap::last_match() const { return state_->last_match; }

std::vector<EvidenceCell> LocalMap::evidence_cells(const std::vector<Point>& points) const {
  constexpr double kSide_m = 1;
  constexpr int kBits = 15, kMask = (1 << kBits) - 1;  // they come again after 33 km
  const auto step = [](double at_m) { return static_cast<int>(std::floor(at_m / kSide_m)) & kMask; };
  std::vector<EvidenceCell> evidence_cells;
  evidence_cells.reserve(points.size());
  for (const Point& point : points) {
    const Point placed = T_local_base() * point;
    evidence_cells.emplace_back(step(placed.x()) << kBits | step(placed.y()));
  }
  return evidence_cells;
}

}  // namespace opal
