#include "localization/localizer_state.hpp"

#include "common/stage_clock.hpp"
#include "localization/alignment/coarse_points.hpp"
#include "localization/alignment/pose_step.hpp"
#include "localization/alignment/registration.hpp"
#include "localization/decision/unmapped_walls.hpp"
#include "localization/observation/observation.hpp"
#include "sensing/motion_check.hpp"

#include <algorithm>
#include <utility>

namespace opal {
namespace {

// After a smaller step of odometry that no scan match confirms, alignment needs no search: it recovers from all that
// odometry may be wrong by.
constexpr double kSafeStep_m = 0.2, kSafeTurn_rad = 0.1;

}  // namespace

// The pipeline; its stages follow.
std::optional<PoseEstimate> Localizer::update(const Sample& recorded) {
  State& s = *state_;
  s.heed(recorded.said);
  if (!tells_motion(recorded)) return std::nullopt;  // as if it had not come
  const Sample sample = s.checked(recorded);
  if (!s.is_keyframe(sample)) return std::nullopt;
  s.laser_odometry.begin_at_newest();
  s.times = {.sensor_s = std::exchange(s.sensor_s, 0)};
  s.stamp_s = sample.stamp_s;
  SeenFeatures seen;  // base_link frame
  {
    StageClock clock(s.times.detect_s);
    seen = detect(s.parts.detectors, sample, s.failures);
  }
  {
    StageClock clock(s.times.local_map_s);
    const Pose2 T_local_before = s.local_map.T_local_base();
    s.local_map.add(sample, seen.features);  // local frame
    s.keyframe = s.local_map.keyframes().back().id;
    if (s.local_map.last_match().converged)
      s.sensors.compare_step(distance_m(s.T_odom_base, sample.T_odom_base),
                             distance_m(T_local_before, s.local_map.T_local_base()));
  }
  s.step_m = s.started ? distance_m(s.T_odom_base, sample.T_odom_base) : 0;
  s.turn_rad = s.started ? angle_between_rad(s.T_odom_base, sample.T_odom_base) : 0;
  s.T_odom_base = sample.T_odom_base;
  const Observation observation = observe(s.local_map, sample, std::move(seen));  // base_link frame
  s.journal.keyframe(sample, s.keyframe, observation);
  s.track(observation, sample);  // map frame from here on
  s.watch(observation);
  s.search_map(observation, sample);
  s.grow();
  s.hypotheses.remember(observation, s.keyframe, s.tempering_weight(), s.retrospective);
  const PoseEstimate estimate = s.with_place(s.estimate(observation));
  s.journal.estimate(estimate, s.hypotheses.alive(), s.status.belief());
  s.settle();
  s.journal.cost(s.times, s.times.total_s());
  s.started = true;
  return estimate;
}

void Localizer::State::heed(const Said& said) {
  if (said.forget) {
    reset();
    journal.forgot();
  }
  if (said.hint) search_session.hint(*said.hint);
}

void Localizer::State::reset() {
  search_session.forget_hint();
  sensors.clear();
  laser_odometry.clear();
  forget_drive();
  journal.reset();
}

/// A description that the drive contradicts turns every pose. What the wheels do not count, the scans may tell.
Sample Localizer::State::checked(Sample sample) {
  StageClock clock(sensor_s);
  sample.T_odom_base = odometry.next(sample.T_odom_base);
  const bool was_frozen = sensors.is_odometry_frozen();
  if (sensors.add(sample)) {
    if (was_frozen && !sensors.is_odometry_frozen() && !laser_odometry.is_sure()) forget_drive();
    const std::string why = sensors.contradiction();
    if (sensors.only_odometry_stands())
      status.suspend(why);
    else
      status.contradict(why);
    journal.sensor(sensors.findings());
  }
  laser_odometry.add(sample, sensors.is_odometry_frozen());
  sample.T_odom_base = laser_odometry.at(sample.T_odom_base);
  return sample;
}

/// Where the robot was does not say where it is.
void Localizer::State::forget_drive() {
  local_map.clear();
  retrospective.clear();
  hypotheses.clear();
  kidnapping.reset();
  rides.reset();
  settling = {};
  status.reset();
  started = false;
  search_session.restart();
}

bool Localizer::State::is_keyframe(const Sample& sample) {
  const bool settles = settling.add(sample.stamp_s, sample.T_odom_base);
  const bool moved = settles || !started || parts.keyframes.are_apart(T_odom_base, sample.T_odom_base),
             sees_other = !moved && !search_session.has_hint() && fits_no_more(sample);
  rode = rides.may_have_ridden(sample, best_pose_at(sample.T_odom_base), sees_other);
  return rode || search_session.has_hint() || moved || sees_other;
}

/// A robot that stands, and sees something else than it should, has been kidnapped or turned.
bool Localizer::State::fits_no_more(const Sample& sample) const {
  if (!status.localized() || hypotheses.alive().empty()) return false;
  const Pose2 T_local_base = local_map.T_local_base_at(sample.T_odom_base);
  Hypothesis carried_on = hypotheses.alive().front().hypothesis;
  carried_on.T_map_local = carried_on.T_map_local * T_local_base * local_map.T_local_base().inverse();
  const Observation seen = observe(local_map, sample, {});
  return seen.points() > 0 && kidnapping.alarming(ensemble.decide(carried_on, seen));
}

double Localizer::State::tempering_weight() const {
  if (!started) return 1;
  const TemperingOptions& tempering = parts.stages.tempering;
  return std::clamp(step_m / tempering.distance_m + turn_rad / tempering.angle_rad, tempering.least_weight, 1.0);
}

/// No scan came on so long a way that it may be laid over a place that only looks like the one where the robot is.
bool Localizer::State::drove_blind() const { return odometry_error_m(step_m) > kWidestWindow_m; }

PoseEstimate Localizer::State::estimate(const Observation& observation) {
  StageClock clock(times.status_s);
  const auto& all = hypotheses.alive();
  const Pose2 T_local_base = local_map.T_local_base();
  if (all.empty()) return status.estimate(all, T_local_base, stamp_s, {tempering_weight(), kidnapping.probability()});
  const Pose2& T_map_local = all.front().hypothesis.T_map_local;
  return status.estimate(all, T_local_base, stamp_s,
                         {tempering_weight(), kidnapping.probability(),
                          unmapped_walls_m(local_map, *parts.map, T_map_local), kidnapping.is_broken() || drove_blind(),
                          newest_agreement.at(T_map_local * T_local_base, observation, *parts.map)});
}

void Localizer::State::track(const Observation& observation, const Sample& sample) {
  StageClock clock(times.track_s);
  // Where the scan matcher could not tell, odometry may be wrong by its usual share.
  const bool is_unchecked = started && !local_map.last_match().converged;
  Eigen::Vector2d window(0, 0);
  if (is_unchecked && (step_m > kSafeStep_m || turn_rad > kSafeTurn_rad)) window = odometry_window(step_m, turn_rad);
  hypotheses.track(observation, tempering_weight(), coarse_points(sample), window);
}

/// What was seen before a ride was seen on another storey, perhaps.
void Localizer::State::carry() {
  hypotheses.carry([this](const Pose2& pose) { return rides.elsewhere(pose); }, local_map.T_local_base());
  local_map.keep_only({});
  search_session.abandon();
  retrospective.forget_until(keyframe);
}

std::optional<Pose2> Localizer::State::best_pose_at(const Pose2& now) const {
  if (hypotheses.alive().empty()) return std::nullopt;
  return hypotheses.alive().front().hypothesis.T_map_local * local_map.T_local_base_at(now);
}

PoseEstimate Localizer::State::with_place(PoseEstimate estimate) const {
  if (estimate.has_pose) estimate.place = place_in_building(parts.map->map(), estimate.T_map_base);
  return estimate;
}

/// Asks whether the robot is still where the best hypothesis has it.
void Localizer::State::watch(const Observation& observation) {
  search_now = false;
  newest_agreement.clear();
  if (rode) carry();
  if (hypotheses.alive().empty()) {
    retrospective.suspect(std::nullopt);
    return kidnapping.reset();
  }
  const Live& best = hypotheses.alive().front();
  const bool suspected = kidnapping.is_suspicious();
  const bool established = status.believed() || best.kidnapped_after.exists();
  const Pose2 T_map_base = best.hypothesis.T_map_local * local_map.T_local_base();
  kidnapping.add({keyframe, tempering_weight(), local_map.last_match().inlier_share,
                  newest_agreement.at(T_map_base, observation, *parts.map), best.scan_nat,
                  best.hypothesis.log_likelihood, established, best.kidnapped_after});
  retrospective.suspect(kidnapping.suspected());
  search_now = !suspected && kidnapping.is_suspicious();
}

/// Once the best hypothesis by which the robot was kidnapped stands for itself, what was before is over.
void Localizer::State::settle() {
  if (!status.localized() || !hypotheses.alive().front().kidnapped_after.exists()) return;
  retrospective.forget_until(hypotheses.alive().front().kidnapped_after);
  const double inherited_nat = hypotheses.settle();
  status.settle(inherited_nat, parts.stages.kidnapping.prior_nat);
  kidnapping.settle(inherited_nat);
}

/// How many chances to search make one search: the surer the robot is, the less there is to find.
int Localizer::State::searched_every() const {
  if (status.localized() && !search_now) return parts.stages.schedule.every_when_localized;
  const bool likely = status.probability() > parts.stages.schedule.likely_probability && !hypotheses.alive().empty();
  return likely && !search_now ? parts.stages.schedule.every_when_likely : 1;
}

/// A place is called localized because no other place explains as much. A search that looks nowhere cannot tell.
UnderConstrained Localizer::State::under_constrained() const {
  const Live* best = hypotheses.alive().empty() ? nullptr : &hypotheses.alive().front();
  const bool knows_much = best && best->hypothesis.log_likelihood >= parts.stages.search.under_constrained_until_nat;
  if (!knows_much || kidnapping.suspected()) return UnderConstrained::nothing_good;
  return status.localized() ? UnderConstrained::never : UnderConstrained::nothing_else;
}

void Localizer::State::search_map(const Observation& observation, const Sample& sample) {
  const MapSearch::Need need{.at_once = hypotheses.alive().empty() || search_now,
                             .anew = search_now,
                             .every = searched_every(),
                             .under_constrained = under_constrained()};
  const GlobalSearch::Scene scene{sample, observation, journal.listening()};
  for (GlobalSearch::Result& found : search_session.look(scene, T_odom_base, need, times)) {
    for (const GlobalSearch::Result::Rejected& rejected : found.rejected)
      journal.candidate_rejected(rejected.candidate, rejected.reason);
    StageClock clock(times.retrospect_s);
    hypotheses.spawn(std::move(found.candidates), observation, tempering_weight(), retrospective);
    journal.searched(found.looked_up, found.places);
  }
}

void Localizer::State::grow() {
  StageClock clock(times.grow_s);
  std::vector<const LocalFeature*> stable;
  for (const LocalFeature& feature : local_map.features())
    if (feature.stable) stable.push_back(&feature);
  hypotheses.forget(local_map);
  hypotheses.grow(stable, local_map);
}

}  // namespace opal
