#include "survey/pose_tracker.hpp"

#include <opal/common/error.hpp>
#include "localization/alignment/registration.hpp"

#include "common/covariance.hpp"
#include "localization/observation/observation.hpp"
#include "survey/fused_motion.hpp"
#include "survey/odometry_direction.hpp"
#include "survey/scan_on_map.hpp"
#include "survey/seen_through.hpp"
#include "survey/tracking_horizon.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace opal {
namespace {

constexpr std::size_t kAlignedPoints = 120, kSearchedPoints = 60, kMeasuredPoints = 400;
constexpr double kFarthestFromMap_m = 30;

// Share of the beams that end on the map less those that pass through it: below the first, something is wrong; above
// the second, it is right. Over a metre driven, tracks that are right stay above 0.3 on full maps, 0.06 on plans.
constexpr double kMisfit = 0, kFit = 0.4;
constexpr std::size_t kFewestTurned = 40;
constexpr double kPushed_m = 0.4;

/// Odometry from scan to scan only: mapped features are the tracker's own business.
LocalMapOptions without_features(LocalMapOptions options) {
  options.optimize_every = 0;
  return options;
}

LocalizerParts checked(LocalizerParts parts) {
  if (!parts.map) throw ConfigError("pose tracker: no map, expected one");
  return parts;
}

}  // namespace

struct PoseTracker::State {
  State(LocalizerParts given, const PoseTrackerOptions& options_given)
      : parts(checked(std::move(given))),
        options(options_given),
        local_map(without_features(parts.local_map), parts.matcher),
        belief(parts.map->map().features().size()),
        horizon(*parts.map, options) {}

  bool moved_enough(const Pose2& T_odom_now) const;
  TrackedKeyframe move(const Sample& sample);
  struct Placed {
    Pose2 T_map_base;
    bool jumped = false;  ///< against odometry and scan matching
  };
  Placed place(const LaserView& view, const TrackedKeyframe& moved) const;
  /// What one laser returned; base_link frame.
  struct Returns {
    std::vector<Point> points;
    Point laser;
  };
  static double fit_at(const ExpectedFeatures& expected, const Returns& seen, const Pose2& pose);
  Pose2 search(const std::vector<Point>& points, const Pose2& around, const Eigen::Vector2d& window) const;
  Eigen::Vector2d window(const Pose2& newest_motion) const;
  Eigen::Matrix3d predicted_covariance(const TrackedKeyframe& moved) const;
  ExpectedFeatures expected_from(const Point& eye) const;
  struct Seen {
    ExpectedFeatures expected;
    Returns returns;
  };
  std::vector<Seen> look(const Sample& sample, TrackedKeyframe& keyframe) const;
  void jump(TrackedKeyframe& keyframe);
  void learn(const TrackedKeyframe& keyframe);
  void judge(const ExpectedFeatures& expected, const Returns& seen, double step_m);

  LocalizerParts parts;
  PoseTrackerOptions options;
  ScaledOdometry scaled{parts.odometry};
  OdometryDirection odometry;
  LocalMap local_map;  ///< follows the corrected odometry
  MapBelief belief;
  TrackingHorizon horizon;
  std::vector<TrackedKeyframe> track;
  TrackedPose last;

  bool ready = false;    ///< there is a pose
  bool started = false;  ///< there was a scan, too
  Eigen::Vector3d start_sigma = Eigen::Vector3d::Zero();
  double fit = 0;                       ///< share of beams on the map less those through it, over the last metres
  OdometryDirection::Measured matched;  ///< the newest motion, as scans tell it
  Pose2 T_odom_base;                    ///< at the newest keyframe
};

bool PoseTracker::State::moved_enough(const Pose2& now) const {
  return !started || parts.keyframes.are_apart(T_odom_base, now);
}

/// Where odometry and scan matching say that the robot is now.
TrackedKeyframe PoseTracker::State::move(const Sample& sample) {
  const Pose2& T_odom_now = sample.T_odom_base;
  if (!started) odometry.start(T_odom_now);
  Sample corrected = sample;
  corrected.T_odom_base = odometry.corrected(T_odom_now);
  const auto [seen, motion] = next_motion(local_map, corrected, parts.local_map);
  matched = {seen.T_before_now, seen.covariance.topLeftCorner<2, 2>()};
  TrackedKeyframe keyframe;
  keyframe.stamp_s = sample.stamp_s;
  keyframe.T_before_now = started ? motion.T_before_now : Pose2();
  keyframe.motion_covariance = motion.covariance;
  keyframe.T_map_base = last.T_map_base * keyframe.T_before_now;
  return keyframe;
}

/// How far the pose may be from the predicted one, where the scan matcher could not tell: (position, heading).
Eigen::Vector2d PoseTracker::State::window(const Pose2& newest_motion) const {
  if (!started) return {std::min(0.8, 2 * start_sigma.head<2>().maxCoeff()), std::min(0.4, 2 * start_sigma.z())};
  if (local_map.last_match().converged) return {0, 0};
  const double step_m = distance_m(Pose2(), newest_motion);
  const double turn_rad = std::abs(newest_motion.heading_rad());
  if (step_m < 0.2 && turn_rad < 0.1) return {0, 0};
  return {std::min(0.5, 0.1 + 0.15 * step_m), std::min(0.35, 0.04 + 0.1 * turn_rad + 0.08 * step_m)};
}

Pose2 PoseTracker::State::search(const std::vector<Point>& points, const Pose2& around,
                                 const Eigen::Vector2d& window) const {
  constexpr double kStep_m = 0.1, kStep_rad = 0.03, kCostOfDistance = 0.02;
  const int steps = static_cast<int>(std::ceil(window.x() / kStep_m));
  const int turns = static_cast<int>(std::ceil(window.y() / kStep_rad));
  Pose2 best = around;
  double best_value = -1;
  for (int turn = -turns; turn <= turns; ++turn)
    for (int i = -steps; i <= steps; ++i)
      for (int j = -steps; j <= steps; ++j) {
        const Pose2 pose(around.x() + i * kStep_m, around.y() + j * kStep_m, around.heading_rad() + turn * kStep_rad);
        const double far = (std::hypot(i, j) * kStep_m) / std::max(kStep_m, window.x()) +
                           std::abs(turn) * kStep_rad / std::max(kStep_rad, window.y());
        const double value = likelihood_field_score(*parts.map, points, pose) - kCostOfDistance * far;
        if (value > best_value) {
          best_value = value;
          best = pose;
        }
      }
  return best;
}

Eigen::Matrix3d PoseTracker::State::predicted_covariance(const TrackedKeyframe& moved) const {
  constexpr double kLeast_m = 0.03, kLeast_rad = 0.015;
  Eigen::Matrix3d covariance =
      horizon.newest_covariance() + turned_covariance(last.T_map_base, moved.motion_covariance);
  covariance.diagonal() += Eigen::Vector3d(kLeast_m, kLeast_m, kLeast_rad).cwiseAbs2();
  return covariance;
}

ExpectedFeatures PoseTracker::State::expected_from(const Point& eye) const {
  return ExpectedFeatures(*parts.map, belief, eye, options.view_m, options.wall_error_m);
}

double PoseTracker::State::fit_at(const ExpectedFeatures& expected, const Returns& seen, const Pose2& pose) {
  return share_on(expected, seen.points, seen.laser, pose) - share_through(expected, seen.points, seen.laser, pose);
}

/// The predicted pose, aligned with what the map holds there.
PoseTracker::State::Placed PoseTracker::State::place(const LaserView& view, const TrackedKeyframe& moved) const {
  const Scan& scan = view.scan;
  const Pose2& predicted = moved.T_map_base;
  const Pose2& T_base_laser = view.T_base_laser;
  const Point laser = T_base_laser.position();
  const auto points = thinned(scan.points, T_base_laser, 0.1, kAlignedPoints).points;
  if (points.empty()) return {predicted, false};
  const auto coarse = thinned(scan.points, T_base_laser, 0.2, kSearchedPoints).points;
  const ExpectedFeatures expected = expected_from(predicted * laser);
  const Eigen::Matrix3d information = predicted_covariance(moved).inverse();
  const auto aligned = [&](const Pose2& guess) { return align_with(expected, points, laser, guess, information); };
  Pose2 best = aligned(predicted);
  if (const Eigen::Vector2d around = window(moved.T_before_now); around.x() > 0) {
    constexpr double kClearlyBetter = 0.05;
    const Pose2 found = aligned(search(coarse, predicted, around));
    const bool near =
        distance_m(found, predicted) < 1.5 * around.x() && angle_between_rad(found, predicted) < 1.5 * around.y();
    if (near && fit_at(expected, {points, laser}, found) > fit_at(expected, {points, laser}, best) + kClearlyBetter)
      best = found;
  }
  if (!started || points.size() < kFewestTurned || fit_at(expected, {points, laser}, best) > kMisfit)
    return {best, false};
  // The robot may have been turned, or pushed, while the odometry did not count.
  const Pose2 found = aligned(search(coarse, predicted, {kPushed_m, std::numbers::pi}));
  return fit_at(expected, {points, laser}, found) > kFit ? Placed{found, true} : Placed{best, false};
}

/// Begins a new horizon.
void PoseTracker::State::jump(TrackedKeyframe& keyframe) {
  constexpr double kSigma_m = 0.2, kSigma_rad = 0.1;
  keyframe.T_before_now = last.T_map_base.inverse() * keyframe.T_map_base;
  keyframe.motion_covariance = Eigen::Vector3d(kSigma_m, kSigma_m, kSigma_rad).cwiseAbs2().asDiagonal();
  horizon.start({keyframe.T_map_base, keyframe.motion_covariance});
}

/// What each laser sees of the map from where the keyframe is; the keyframe gets what it measures.
std::vector<PoseTracker::State::Seen> PoseTracker::State::look(const Sample& sample, TrackedKeyframe& keyframe) const {
  std::vector<Seen> all;
  for (const LaserView& view : sample.views) {
    const Point laser = view.T_base_laser.position();
    Returns returns{thinned(view.scan.points, view.T_base_laser, 0.03, kMeasuredPoints).points, laser};
    const Seen& seen = all.emplace_back(Seen{expected_from(keyframe.T_map_base * laser), std::move(returns)});
    for (MapMeasurement& measured : measure(seen.expected, seen.returns.points, laser, keyframe.T_map_base, options))
      keyframe.measurements.push_back(std::move(measured));
  }
  return all;
}

void PoseTracker::State::learn(const TrackedKeyframe& keyframe) {
  for (const MapMeasurement& measured : keyframe.measurements) {
    FeatureBelief& feature = belief[measured.feature];
    ++feature.observations;
    feature.covered_m = std::max(feature.covered_m, covered_m(measured));
  }
}

/// Whether scans fit the map where the robot is said to be. A scan without points does not tell.
void PoseTracker::State::judge(const ExpectedFeatures& expected, const Returns& seen, double step_m) {
  if (seen.points.empty()) return;
  last.on_map_share = share_on(expected, seen.points, seen.laser, last.T_map_base);
  last.through_share = share_through(expected, seen.points, seen.laser, last.T_map_base);
  const double newest = started ? std::min(1.0, step_m / options.lost_after_m) : 1;
  fit += newest * (last.on_map_share - last.through_share - fit);
  last.lost = fit < 0;
}

PoseTracker::PoseTracker(LocalizerParts parts, PoseTrackerOptions options)
    : state_(std::make_unique<State>(std::move(parts), options)) {}
PoseTracker::~PoseTracker() = default;

void PoseTracker::start(const Pose2& T_map_base, const Eigen::Vector3d& sigma) {
  State& s = *state_;
  if (!T_map_base.position().allFinite() || !std::isfinite(T_map_base.heading_rad()) || !sigma.allFinite())
    throw ConfigError("start pose: not finite, expected numbers");
  if (s.parts.map->within(T_map_base.position(), kFarthestFromMap_m).empty()) {
    const auto [low, high] = s.parts.map->bounds();
    throw ConfigError("start pose: x " + std::to_string(T_map_base.x()) + ", y " + std::to_string(T_map_base.y()) +
                      " is farther than 30 m from everything on the map, which reaches from x " +
                      std::to_string(low.x()) + ", y " + std::to_string(low.y()) + " to x " + std::to_string(high.x()) +
                      ", y " + std::to_string(high.y()));
  }
  s.local_map.clear();
  s.start_sigma = sigma.cwiseMax(Eigen::Vector3d(0.01, 0.01, 0.005));
  s.horizon.start({T_map_base, s.start_sigma.cwiseAbs2().asDiagonal()});
  s.track.clear();
  s.last = {};
  s.last.T_map_base = T_map_base;
  s.last.covariance = s.start_sigma.cwiseAbs2().asDiagonal();
  s.ready = true;
  s.started = false;
}

void PoseTracker::forget_offsets() {
  state_->belief.assign(state_->belief.size(), {});
  state_->horizon.forget_offsets();
}

std::optional<TrackedPose> PoseTracker::update(const Sample& recorded) {
  State& s = *state_;
  Sample sample = recorded;
  sample.T_odom_base = s.scaled.next(recorded.T_odom_base);
  if (!s.ready || !s.moved_enough(sample.T_odom_base)) return std::nullopt;
  const Pose2 T_map_before = s.last.T_map_base;
  TrackedKeyframe keyframe = s.move(sample);
  const State::Placed placed = s.place(sample.views.front(), keyframe);
  keyframe.T_map_base = placed.T_map_base;
  if (placed.jumped) s.jump(keyframe);
  const std::vector<State::Seen> seen = s.look(sample, keyframe);
  s.learn(keyframe);
  s.track.push_back(keyframe);
  s.horizon.add(std::move(keyframe));
  s.horizon.solve(s.belief);
  s.last.stamp_s = sample.stamp_s;
  s.last.T_map_base = s.horizon.newest().T_map_base;
  s.last.covariance = s.horizon.newest_covariance();
  s.last.features = static_cast<int>(s.track.back().measurements.size());
  s.judge(seen.front().expected, seen.front().returns, distance_m(T_map_before, s.last.T_map_base));
  for (const auto& [expected, returns] : seen)
    count_seen(s.belief, expected, returns.points, returns.laser, s.last.T_map_base);
  s.track.back().T_map_base = s.last.T_map_base;
  s.horizon.slide(s.belief);
  const Pose2 found = T_map_before.inverse() * s.last.T_map_base;
  const Eigen::Matrix3d found_covariance = turned_covariance(T_map_before.inverse(), s.last.covariance);
  s.odometry.advance(sample.T_odom_base, s.matched, {found, found_covariance.topLeftCorner<2, 2>()});
  s.T_odom_base = sample.T_odom_base;
  s.started = true;
  return s.last;
}

Pose2 PoseTracker::T_map_base_at(const Pose2& T_odom_base) const {
  const State& s = *state_;
  if (!s.started) return s.last.T_map_base;
  return s.last.T_map_base * (s.local_map.T_local_base().inverse() *
                              s.local_map.T_local_base_at(s.odometry.corrected(s.scaled.at(T_odom_base))));
}

const TrackedPose& PoseTracker::last() const { return state_->last; }
const MapView& PoseTracker::map() const { return *state_->parts.map; }
const MapBelief& PoseTracker::belief() const { return state_->belief; }
const std::vector<TrackedKeyframe>& PoseTracker::track() const { return state_->track; }

}  // namespace opal
