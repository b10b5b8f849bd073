#include <opal/localization/localizer.hpp>

#include "localization/tree/hypothesis_set.hpp"
#include "localization/scoring/scorer_ensemble.hpp"
#include "localization/scoring/observation.hpp"
#include "localization/events/run_journal.hpp"
#include "localization/search/search_schedule.hpp"
#include "localization/search/candidate_generation.hpp"
#include "localization/decision/status.hpp"
#include "localization/decision/unmapped_walls.hpp"

#include "common/cpu_clock.hpp"
#include "localization/alignment/registration.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace opal {
namespace {

constexpr std::size_t kPoints = 100, kCoarsePoints = 40, kFreeBeams = 25;

/// Adds the CPU time of a scope to a stage.
class StageClock {
 public:
  explicit StageClock(double& stage_s) : stage_s_(stage_s), start_s_(thread_cpu_s()) {}
  ~StageClock() { stage_s_ += thread_cpu_s() - start_s_; }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  double& stage_s_;
  double start_s_;
};

bool better_score(const Candidate& a, const Candidate& b) { return a.score > b.score; }

}  // namespace

struct Localizer::State {
  State(LocalizerParts parts_given, EventSink* sink)
      : parts(std::move(parts_given)),
        options(read_association_options(parts.association, "association")),
        local_map(parts.local_map, parts.matcher),
        ensemble(parts.scorers, parts.map, failures),
        generator(parts.map, parts.patterns, options),
        journal(sink ? *sink : nobody, parts.map, ensemble, generator),
        retrospective(parts.map, ensemble, options),
        hypotheses(parts.map, ensemble, options, journal),
        change(options),
        schedule(options),
        status(options) {}

  bool moved_enough(const Pose2& T_odom_base) const;
  bool fits_no_more(const Scan& scan, const Pose2& T_odom_base) const;
  std::vector<Feature> detect(const Scan& scan);
  Observation observe(const Scan& scan, const std::vector<Feature>& features) const;
  double tempering_weight() const;  ///< of the newest scan
  PoseEstimate estimate();
  void track(const Observation& observation, const Scan& scan);
  void watch();
  void settle();
  bool time_to_search();
  int searched_every() const;
  void seed(const Observation& observation, const Scan& scan);
  std::vector<SearchFeature> seed_features(const Observation& observation) const;
  bool worth_under_constrained_search(const std::vector<Candidate>& found) const;
  void verify(std::vector<Candidate>& candidates, const Observation& observation, const Scan& scan,
              std::size_t keep);
  Hypothesis aligned(Candidate& candidate, const Observation& observation, double sigma_m) const;
  void keep_best(std::vector<Candidate>& candidates, double distance_m, std::size_t keep);
  void grow();
  std::vector<int> pattern_of_best() const;

  NullEventSink nobody;
  LocalizerParts parts;
  AssociationOptions options;
  std::map<std::string, int> failures;
  LocalMap local_map;
  ScorerEnsemble ensemble;
  CandidateGenerator generator;
  RunJournal journal;
  RetrospectiveVerification retrospective;
  HypothesisSet hypotheses;
  KidnapDetector change;
  SearchSchedule schedule;
  StatusEstimator status;
  std::vector<Hypothesis> alive;  ///< what hypotheses() shows

  bool started = false;
  double stamp_s = 0;
  int keyframe = 0;
  Pose2 T_odom_base;        ///< at the newest keyframe
  double step_m = 0, turn_rad = 0;  ///< since the previous keyframe
  bool search_now = false;  ///< there is reason to believe that the robot was kidnapped, since this scan
  StageTimes times;
};

// ---------------------------------------------------------------------------------------------- the pipeline

std::optional<PoseEstimate> Localizer::update(const Scan& scan, const Pose2& T_odom_base) {
  State& s = *state_;
  if (!s.moved_enough(T_odom_base) && !s.fits_no_more(scan, T_odom_base)) return std::nullopt;
  s.times = {};
  s.stamp_s = scan.stamp_s;
  const std::vector<Feature> features = s.detect(scan);  // sensor frame
  {
    StageClock clock(s.times.local_map_s);
    s.local_map.add(scan, features, T_odom_base, s.parts.laser.T_base_laser);  // local frame
  }
  s.step_m = s.started ? distance_m(s.T_odom_base, T_odom_base) : 0;
  s.turn_rad = s.started ? angle_between_rad(s.T_odom_base, T_odom_base) : 0;
  s.T_odom_base = T_odom_base;
  const Observation observation = s.observe(scan, features);  // base_link frame
  s.journal.keyframe(s.stamp_s, s.keyframe, scan, s.parts.laser.T_base_laser, observation);
  s.track(observation, scan);                              // map frame from here on
  s.watch();
  if (s.time_to_search()) s.seed(observation, scan);
  s.grow();
  const double best_nat = s.hypotheses.alive().empty() ? 0 : s.hypotheses.alive().front().scan_nat;
  s.retrospective.remember(observation, s.keyframe, s.tempering_weight(), best_nat);
  const PoseEstimate estimate = s.estimate();
  s.settle();
  s.journal.estimate(estimate, s.hypotheses.alive(), s.status.belief());
  s.journal.cost(s.times, s.times.total_s());
  s.started = true;
  ++s.keyframe;
  return estimate;
}

// ---------------------------------------------------------------------------------------------- its stages

bool Localizer::State::moved_enough(const Pose2& now) const {
  return !started || distance_m(T_odom_base, now) > parts.keyframes.distance_m ||
         angle_between_rad(T_odom_base, now) > parts.keyframes.angle_rad;
}

/// A robot that stands, and sees something else than it should, has been kidnapped or turned.
bool Localizer::State::fits_no_more(const Scan& scan, const Pose2& now) const {
  if (!status.localized() || hypotheses.alive().empty()) return false;
  const Pose2 T_local_base = local_map.T_local_base_at(now);
  Hypothesis carried_on = hypotheses.alive().front().hypothesis;
  carried_on.T_map_local = carried_on.T_map_local * T_local_base * local_map.T_local_base().inverse();
  const Observation seen = observe(scan, {});
  return !seen.points.empty() && change.alarming(ensemble.decide(carried_on, seen));
}

std::vector<Feature> Localizer::State::detect(const Scan& scan) {
  StageClock clock(times.detect_s);
  std::vector<Feature> features;
  for (const auto& detector : parts.detectors) {
    std::string cause;
    try {
      for (Feature& feature : detector.part->detect(scan)) features.push_back(std::move(feature));
      continue;
    } catch (const std::exception& error) {
      cause = error.what();
    } catch (...) {
      cause = "threw something that is no std::exception";
    }
    if (failures[detector.name]++ == 0) spdlog::warn("{}: skipped: {}", detector.name, cause);
  }
  return features;
}

Observation Localizer::State::observe(const Scan& scan, const std::vector<Feature>& features) const {
  const Pose2& T_base_laser = parts.laser.T_base_laser;
  ThinnedScan seen = thinned(scan.points, T_base_laser, 0.1, kPoints);
  Observation observation{local_map, std::move(seen.points),
                          thinned_bearings(scan.free_bearings_rad, T_base_laser, kFreeBeams),
                          scan.range_max_m, T_base_laser.position(), {}, std::move(seen.beams)};
  for (const Feature& feature : features) observation.features.push_back(transformed(T_base_laser, feature));
  observation.evidence_cells = local_map.evidence_cells(observation.points);
  return observation;
}

double Localizer::State::tempering_weight() const {
  if (!started) return 1;
  return std::clamp(step_m / options.novelty_m + turn_rad / options.novelty_rad, options.least_novelty, 1.0);
}

PoseEstimate Localizer::State::estimate() {
  StageClock clock(times.status_s);
  const auto& all = hypotheses.alive();
  const double unmapped_m = all.empty() ? 0 : unmapped_walls_m(local_map, *parts.map, all.front().hypothesis.T_map_local);
  return status.estimate(all, local_map.T_local_base(), stamp_s, {tempering_weight(), change.probability(), unmapped_m});
}

void Localizer::State::track(const Observation& observation, const Scan& scan) {
  StageClock clock(times.track_s);
  // Where the scan matcher could not tell, odometry may be wrong by its usual share.
  Eigen::Vector2d window(0, 0);
  if (started && !local_map.last_match().converged && (step_m > 0.2 || turn_rad > 0.1))
    window = {std::min(0.5, 0.1 + 0.15 * step_m), std::min(0.35, 0.04 + 0.1 * turn_rad + 0.08 * step_m)};
  const auto coarse = thinned(scan.points, parts.laser.T_base_laser, 0.2, kCoarsePoints).points;
  hypotheses.track(observation, tempering_weight(), coarse, window);
}

/// Asks whether the robot is still where the best hypothesis has it.
void Localizer::State::watch() {
  search_now = false;
  if (hypotheses.alive().empty()) return change.reset();
  const Live& best = hypotheses.alive().front();
  const bool suspected = change.suspected().has_value();
  const bool established = status.believed() || best.kidnapped_after >= 0;
  change.add({keyframe, tempering_weight(), local_map.last_match().inlier_share, best.scan_nat,
              best.hypothesis.log_likelihood, established});
  retrospective.suspect(change.suspected());
  search_now = !suspected && change.suspected().has_value();
}

/// Once the best hypothesis by which the robot was kidnapped stands for itself, what was before is over.
void Localizer::State::settle() {
  if (!status.localized() || hypotheses.alive().front().kidnapped_after < 0) return;
  retrospective.forget_until(hypotheses.alive().front().kidnapped_after);
  status.settle(hypotheses.settle());
}

bool Localizer::State::time_to_search() {
  return schedule.time_to_search(T_odom_base, hypotheses.alive().empty() || search_now, searched_every());
}

/// How many chances to search make one search: the surer the robot is, the less there is to find.
int Localizer::State::searched_every() const {
  if (status.localized()) return options.seed_every_when_localized;
  const bool likely = status.probability() > options.likely_probability && !hypotheses.alive().empty();
  return likely && !search_now ? options.seed_every_when_likely : 1;
}

std::vector<SearchFeature> Localizer::State::seed_features(const Observation& observation) const {
  std::vector<SearchFeature> seeds;
  if (options.seed_from_stable) {
    const Pose2 T_base_local = local_map.T_local_base().inverse();
    for (const LocalFeature& local : local_map.features())
      if (local.stable) seeds.push_back({transformed(T_base_local, local.feature), local.id});
    return seeds;
  }
  for (std::size_t k = 0; k < observation.features.size(); ++k)
    seeds.push_back({observation.features[k], local_map.last_associations()[k]});
  return seeds;
}

void Localizer::State::verify(std::vector<Candidate>& candidates, const Observation& full, const Scan& scan,
                              std::size_t keep) {
  // Two coarse-to-fine filters: a few beams for all candidates, all beams for those that look good.
  constexpr double kOnePlace_m = 0.2;
  Observation few{local_map, thinned(scan.points, parts.laser.T_base_laser, 0.1, kCoarsePoints).points, {},
                  full.range_max_m, full.laser_position, full.features};
  few.evidence_cells = local_map.evidence_cells(few.points);
  for (Candidate& candidate : candidates) candidate.score = ensemble.decide(aligned(candidate, few, 0.15), few);
  keep_best(candidates, kOnePlace_m, keep);
  for (Candidate& candidate : candidates) {
    candidate.verdict = ensemble.judge(aligned(candidate, full, 0.12), full);
    candidate.score = candidate.verdict.nat;
  }
  keep_best(candidates, kOnePlace_m, keep);
}

/// Moves the candidate to where the scan fits best. @return the hypothesis that it would be.
Hypothesis Localizer::State::aligned(Candidate& candidate, const Observation& observation, double sigma_m) const {
  RefinementOptions refinement;
  refinement.iterations = 4;
  refinement.sigma_m = sigma_m;
  refinement.prior_position = 0.01;
  refinement.prior_heading = 0.05;
  Pose2& pose = candidate.T_map_base;
  pose = refine_on_map(*parts.map, observation.points, observation.laser_position, pose, refinement);
  Hypothesis trial;
  trial.T_map_local = pose * local_map.T_local_base().inverse();
  trial.associations = candidate.pairs;
  return trial;
}

/// Best first, one per place.
void Localizer::State::keep_best(std::vector<Candidate>& candidates, double distance, std::size_t keep) {
  constexpr double kAngle_rad = 0.06;
  std::stable_sort(candidates.begin(), candidates.end(), better_score);
  std::vector<Pose2> poses;
  for (const Candidate& candidate : candidates) poses.push_back(candidate.T_map_base);
  const std::vector<std::size_t> chosen = distinct_places(poses, distance, kAngle_rad, keep);
  if (journal.listening() && chosen.size() == keep)
    for (std::size_t k = chosen.back() + 1; k < candidates.size(); ++k)
      journal.candidate_rejected(candidates[k], std::to_string(keep) + " places score better");
  std::vector<Candidate> kept;
  for (std::size_t k : chosen) kept.push_back(std::move(candidates[k]));
  candidates = std::move(kept);
}

/// Patterns with a free parameter have many candidates: they are looked up where those that fix the pose found
/// nothing good, and no hypothesis has gathered evidence yet.
bool Localizer::State::worth_under_constrained_search(const std::vector<Candidate>& found) const {
  const bool found_good = !found.empty() && found.front().score >= options.loose_below_nat;
  const auto& alive_now = hypotheses.alive();
  const bool tracked_good =
      !alive_now.empty() && alive_now.front().hypothesis.log_likelihood >= options.loose_until_nat;
  return !found_good && (!tracked_good || change.suspected());
}

void Localizer::State::seed(const Observation& observation, const Scan& scan) {
  constexpr std::size_t kFewestPoints = 15;
  if (observation.points.size() < kFewestPoints) return;
  const auto coarse = thinned(scan.points, parts.laser.T_base_laser, 0.2, kCoarsePoints).points;
  const std::vector<SearchFeature> features = seed_features(observation);
  std::vector<Candidate> candidates;
  std::vector<CandidateGenerator::LookedUp> looked_up;
  std::size_t places = 0;
  for (const bool under_constrained : {false, true}) {
    if (under_constrained && !worth_under_constrained_search(candidates)) break;
    CandidateGenerator::Proposal proposed;
    {
      StageClock clock(times.associate_s);
      proposed = generator.propose(features, coarse, under_constrained);
    }
    StageClock clock(times.verify_s);
    places += proposed.candidates.size();
    looked_up.insert(looked_up.end(), proposed.looked_up.begin(), proposed.looked_up.end());
    verify(proposed.candidates, observation, scan, options.seed_hypotheses);
    for (Candidate& candidate : proposed.candidates) candidates.push_back(std::move(candidate));
  }
  {
    StageClock clock(times.verify_s);
    std::stable_sort(candidates.begin(), candidates.end(), better_score);
    if (candidates.size() > static_cast<std::size_t>(options.seed_hypotheses))
      candidates.resize(options.seed_hypotheses);
    hypotheses.spawn(std::move(candidates), observation, tempering_weight(), retrospective);
  }
  schedule.searched(std::transform_reduce(looked_up.begin(), looked_up.end(), std::size_t{0}, std::plus<>(),
                                          [](const CandidateGenerator::LookedUp& pattern) { return pattern.expected; }));
  journal.searched(looked_up, places);
}

void Localizer::State::grow() {
  StageClock clock(times.associate_s);
  std::vector<const LocalFeature*> stable;
  for (const LocalFeature& feature : local_map.features())
    if (feature.stable) stable.push_back(&feature);
  hypotheses.forget(local_map);
  hypotheses.grow(stable, local_map);
}

/// Local features of the first node of its branch.
std::vector<int> Localizer::State::pattern_of_best() const {
  const AssociationTree& tree = hypotheses.tree();
  int node = hypotheses.alive().front().leaf;
  while (tree.node(node).parent >= 0) node = tree.node(node).parent;
  std::vector<int> features;
  for (const Association& pair : tree.node(node).pairs) features.push_back(pair.local_feature);
  return features;
}

// ---------------------------------------------------------------------------------------------- the rest

Localizer::Localizer(LocalizerParts parts, EventSink* events)
    : state_(std::make_unique<State>(std::move(parts), events)) {}
Localizer::~Localizer() = default;

PoseEstimate Localizer::estimate_at(double stamp_s, const Pose2& T_odom_base) const {
  return state_->status.at(stamp_s, state_->local_map.T_local_base_at(T_odom_base));
}

void Localizer::reset() {
  State& s = *state_;
  s.local_map.clear();
  s.retrospective.clear();
  s.hypotheses.clear();
  s.change.reset();
  s.search_now = false;
  s.status.reset();
  s.started = false;
  s.schedule.reset();
  s.journal.reset();
}

void Localizer::keep_pattern() {
  if (!state_->hypotheses.alive().empty()) state_->local_map.keep_only(state_->pattern_of_best());
}

const LocalMap& Localizer::local_map() const { return state_->local_map; }
const MapView& Localizer::map() const { return *state_->parts.map; }

const std::vector<Hypothesis>& Localizer::hypotheses() const {
  state_->alive.clear();
  for (const Live& live : state_->hypotheses.alive()) state_->alive.push_back(live.hypothesis);
  return state_->alive;
}

std::map<std::string, Score> Localizer::scores_of(int hypothesis) const {
  std::map<std::string, Score> scores;
  for (const Live& live : state_->hypotheses.alive())
    if (live.hypothesis.id == hypothesis)
      for (std::size_t k = 0; k < live.scores.size(); ++k)
        scores[state_->ensemble.scorers()[k].name] = live.scores[k];
  return scores;
}

const StageTimes& Localizer::last_times() const { return state_->times; }
const std::map<std::string, int>& Localizer::plugin_failures() const { return state_->failures; }

}  // namespace opal
