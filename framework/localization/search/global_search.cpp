#include "localization/search/global_search.hpp"

#include "common/stage_clock.hpp"
#include "localization/alignment/coarse_points.hpp"
#include "localization/alignment/pose_grid.hpp"
#include "localization/alignment/registration.hpp"
#include "localization/observation/observation.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace opal {
namespace {

// Of the few points by which scorers judge all candidates: nearer to each other than coarse points, for beams tell more
// than a likelihood field.
constexpr double kFewSpacing_m = 0.1;
// How a candidate is aligned. Its guess comes from a pattern or a grid, and is worth less than dead reckoning: it holds
// the candidate only where the scan says nothing. Weights are relative to a point's.
constexpr double kGuessPosition = 0.01, kGuessHeading = 0.05;
constexpr int kIterations = 4;  // one less than usual: a candidate is aligned twice
// The grid about a hint: two standard deviations, but no more than time allows, in steps that alignment recovers from.
constexpr double kHintSigmas = 2, kHintMost_m = 2, kHintMost_rad = 0.6, kHintStep_m = 0.25, kHintStep_rad = 0.1;
constexpr std::size_t kHintPlaces = 20;  // that scorers judge
// Aligned candidates nearer than this are one place: alignment ends within a step or two of the same pose.
constexpr PoseTolerance kAlignedApart{0.2, 0.06};
// Of the grid about a hint no two neighbours are kept: alignment reaches from one to the other.
constexpr PoseTolerance kHintedApart{0.3, 0.12};

std::vector<const Hypothesis*> pointers_to(const std::vector<Hypothesis>& hypotheses) {
  std::vector<const Hypothesis*> pointers;
  for (const Hypothesis& hypothesis : hypotheses) pointers.push_back(&hypothesis);
  return pointers;
}

bool better(const VerifiedCandidate& a, const VerifiedCandidate& b) { return a.nat > b.nat; }

/// The same place on the other storeys of the same building, going by their own frames.
std::vector<Pose2> above_and_below(const SemanticMap& map, const Pose2& T_map_base) {
  std::vector<Pose2> places;
  const MapStorey* here = storey_at(map, T_map_base.position());
  for (const MapStorey& storey : map.origin().storeys)
    if (&storey != here && storey.building == here->building)
      places.push_back(storey.to_map(here->to_storey(T_map_base)));
  return places;
}

}  // namespace

std::vector<SearchFeature> GlobalSearch::features_for(const Observation& seen) const {
  std::vector<SearchFeature> features;
  if (options_.from_stable) {
    const Pose2 T_base_local = seen.local_map.T_local_base().inverse();
    for (const LocalFeature& local : seen.local_map.features())
      if (local.stable) features.push_back({transformed(T_base_local, local.feature), local.id});
    return features;
  }
  for (std::size_t k = 0; k < seen.features.size(); ++k)
    features.push_back({seen.features[k], seen.local_map.last_associations()[k]});
  return features;
}

/// Moves the candidate to where the scan fits best. @return the hypothesis that it would be.
Hypothesis GlobalSearch::aligned(Candidate& candidate, const Observation& observation, double sigma_m) const {
  RefinementOptions refinement;
  refinement.iterations = kIterations;
  refinement.sigma_m = sigma_m;
  refinement.prior_position = kGuessPosition;
  refinement.prior_heading = kGuessHeading;
  Pose2& pose = candidate.T_map_base;
  pose = refine_on_map(*map_, observation.scans, pose, refinement);
  Hypothesis trial;
  trial.T_map_local = pose * observation.local_map.T_local_base().inverse();
  trial.associations = candidate.pairs;
  return trial;
}

/// Best first, one per place.
void GlobalSearch::keep_best(std::vector<VerifiedCandidate>& candidates, const Scene& scene, Result& result) const {
  const auto keep = static_cast<std::size_t>(options_.hypotheses);
  std::stable_sort(candidates.begin(), candidates.end(), better);
  std::vector<Pose2> poses;
  for (const VerifiedCandidate& each : candidates) poses.push_back(each.candidate.T_map_base);
  const std::vector<std::size_t> chosen = distinct_places(poses, kAlignedApart, keep);
  if (scene.keep_rejected && chosen.size() == keep)
    for (std::size_t k = chosen.back() + 1; k < candidates.size(); ++k)
      result.rejected.push_back({candidates[k], std::to_string(keep) + " places score better"});
  std::vector<VerifiedCandidate> kept;
  for (std::size_t k : chosen) kept.push_back(std::move(candidates[k]));
  candidates = std::move(kept);
}

/// The places about a hint where a few points lie best, one per place.
std::vector<Candidate> GlobalSearch::candidates_near(const PoseHint& hint, std::span<const Point> coarse) const {
  const PoseGrid grid =
      PoseGrid::covering(std::min(kHintMost_m, kHintSigmas * hint.sigma_m),
                         std::min(kHintMost_rad, kHintSigmas * hint.sigma_rad), kHintStep_m, kHintStep_rad);
  std::vector<std::pair<double, Pose2>> places;
  for_each_pose(hint.T_map_base, grid, [&](const Pose2& pose, const GridSteps&) {
    if (options_.may_be_at(pose.position())) places.emplace_back(likelihood_field_score(*map_, coarse, pose), pose);
  });
  std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Pose2> poses;
  for (const auto& [score, pose] : places) poses.push_back(pose);
  std::vector<Candidate> candidates;
  for (std::size_t k : distinct_places(poses, kHintedApart, kHintPlaces))
    candidates.push_back({poses[k], Origin::hint});
  return candidates;
}

/// The same places on other storeys, which often look alike: a candidate never comes without these alternatives.
std::vector<Candidate> GlobalSearch::above_and_below_best(const std::vector<VerifiedCandidate>& found) const {
  constexpr std::size_t kBest = 6;
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < std::min(kBest, found.size()); ++k)
    for (const Pose2& pose : above_and_below(map_->map(), found[k].candidate.T_map_base))
      if (options_.may_be_at(pose.position())) candidates.push_back({pose, Origin::other_storey});
  return candidates;
}

/// Returns only, and few of them.
Observation GlobalSearch::with_few_points(const Scene& scene) {
  const Observation& full = scene.observation;
  Observation few{full.local_map, {}, full.features, full.feature_scans};
  const std::vector<ThinnedScan> seen = thinned(scene.sample, kFewSpacing_m, kCoarsePoints);
  for (std::size_t k = 0; k < seen.size(); ++k)
    few.scans.push_back({.laser_position = full.scans[k].laser_position,
                         .points = seen[k].points,
                         .range_max_m = full.scans[k].range_max_m,
                         .beams = seen[k].beams,
                         .evidence_cells = full.local_map.evidence_cells(seen[k].points)});
  return few;
}

/// Coarse to fine: a few beams for all candidates, all beams for those that look good.
std::vector<VerifiedCandidate> GlobalSearch::verified(std::vector<Candidate> candidates, const Scene& scene,
                                                      Result& result) const {
  constexpr double kCoarseSigma_m = 0.15, kFineSigma_m = 0.12;
  const Observation& full = scene.observation;
  const Observation few = with_few_points(scene);
  std::vector<Hypothesis> trials;
  for (Candidate& candidate : candidates) trials.push_back(aligned(candidate, few, kCoarseSigma_m));
  const std::vector<double> nats = ensemble_.decide_all(pointers_to(trials), few);
  std::vector<VerifiedCandidate> verified;
  for (std::size_t k = 0; k < nats.size(); ++k) verified.push_back({std::move(candidates[k]), nats[k]});
  keep_best(verified, scene, result);
  trials.clear();
  for (VerifiedCandidate& each : verified) trials.push_back(aligned(each.candidate, full, kFineSigma_m));
  std::vector<ScorerEnsemble::Verdict> verdicts = ensemble_.judge_all(pointers_to(trials), full);
  for (std::size_t k = 0; k < verified.size(); ++k) {
    verified[k].verdict = std::move(verdicts[k]);
    verified[k].nat = verified[k].verdict.nat;
  }
  keep_best(verified, scene, result);
  return verified;
}

GlobalSearch::Ongoing GlobalSearch::begin(const Scene& scene, UnderConstrained under_constrained,
                                          StageTimes& times) const {
  const StageClock clock(times.generate_s);
  std::vector<Point> coarse = coarse_points(scene.sample);
  std::vector<SearchFeature> features = features_for(scene.observation);
  Ongoing search(generator_.ask(features, coarse, PatternKind::constrained));
  search.T_local_base = scene.observation.local_map.T_local_base();
  search.features = std::move(features);
  search.coarse = std::move(coarse);
  search.may_ask_more = under_constrained == UnderConstrained::nothing_good ||
                        (under_constrained == UnderConstrained::nothing_else && search.inquiry.is_empty());
  return search;
}

bool GlobalSearch::look_up(Ongoing& search) const {
  const auto most = options_.places_per_scan > 0 ? static_cast<std::size_t>(options_.places_per_scan)
                                                 : std::numeric_limits<std::size_t>::max();
  return generator_.look_up(search.inquiry, most);
}

/// They have many candidates each.
bool GlobalSearch::ask_more(Ongoing& search, StageTimes& times) const {
  const std::vector<VerifiedCandidate>& found = search.result.candidates;
  const bool found_good = !found.empty() && found.front().nat >= options_.under_constrained_below_nat;
  if (!std::exchange(search.may_ask_more, false) || found_good) return false;
  const StageClock clock(times.generate_s);
  search.inquiry = generator_.ask(search.features, search.coarse, PatternKind::under_constrained);
  return true;
}

/// The robot has driven on since the search began: the candidates are where it is now.
std::vector<Candidate> GlobalSearch::propose(Ongoing& search, const Scene& scene) const {
  CandidateGenerator::Proposal proposed = generator_.propose(std::move(search.inquiry));
  const Pose2 &T_local_begun = search.T_local_base, &T_local_base = scene.observation.local_map.T_local_base();
  if (!is_same_pose(T_local_begun, T_local_base))
    for (Candidate& candidate : proposed.candidates)
      candidate.T_map_base = candidate.T_map_base * (T_local_begun.inverse() * T_local_base);
  search.result.places += proposed.candidates.size();
  for (CandidateGenerator::LookedUp& pattern : proposed.looked_up)
    search.result.looked_up.push_back(std::move(pattern));
  return std::move(proposed.candidates);
}

void GlobalSearch::add_verified(std::vector<Candidate> candidates, const Scene& scene, Result& result) const {
  for (VerifiedCandidate& each : verified(std::move(candidates), scene, result))
    result.candidates.push_back(std::move(each));
}

GlobalSearch::Result GlobalSearch::finished(Result result, const Scene& scene) const {
  keep_best(result.candidates, scene, result);  // those that fix the pose and those that do not may be at one place
  if (!map_->map().origin().storeys.empty()) add_verified(above_and_below_best(result.candidates), scene, result);
  return result;
}

std::optional<GlobalSearch::Result> GlobalSearch::go_on(Ongoing& search, const Scene& scene, StageTimes& times) const {
  do {
    std::vector<Candidate> proposed;
    {
      const StageClock clock(times.generate_s);
      if (!look_up(search)) return std::nullopt;
      proposed = propose(search, scene);
    }
    const StageClock clock(times.search_s);
    add_verified(std::move(proposed), scene, search.result);
  } while (ask_more(search, times));
  const StageClock clock(times.search_s);
  return finished(std::move(search.result), scene);
}

GlobalSearch::Result GlobalSearch::look_near(const PoseHint& hint, const Scene& scene, StageTimes& times) const {
  std::vector<Candidate> proposed;
  {
    const StageClock clock(times.generate_s);
    proposed = candidates_near(hint, coarse_points(scene.sample));
  }
  const StageClock clock(times.search_s);
  Result result;
  add_verified(std::move(proposed), scene, result);
  return finished(std::move(result), scene);
}

}  // namespace opal
