#include "localization/tree/hypothesis_set.hpp"

#include "common/phrases.hpp"
#include "common/pose_tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace opal {
namespace {

// Hypotheses nearer than this are one: alignment brings both to the same pose.
constexpr PoseTolerance kMerge{0.3, 0.1};
// A candidate nearer than this to a hypothesis renews it. The two come from different scans and priors, so one place
// has them a little further apart than two hypotheses of one scan.
constexpr PoseTolerance kRenewed{kMerge.position_m + 0.1, kMerge.heading_rad + 0.05};
// A candidate that gains less over a hypothesis at its place is as good as that: alignment from another guess ends a
// little elsewhere.
constexpr double kRenewalGain_nat = 0.3;
// A scan that puts a hypothesis this far from where it was known to be is half believed (PoseFilterOptions).
constexpr double kPoseJump_m = 0.2;

/// Siblings that no scan has judged yet are alike but for what they leave unexplained (3.4.5).
bool better(const Live& a, const Live& b) {
  if (a.hypothesis.log_likelihood != b.hypothesis.log_likelihood)
    return a.hypothesis.log_likelihood > b.hypothesis.log_likelihood;
  return a.not_on_map < b.not_on_map;
}

void sort_best_first(std::vector<Live>& alive) { std::stable_sort(alive.begin(), alive.end(), better); }

bool ended(const Live& live) { return !live.leaf.exists(); }

/// The same place and associations, as if it had met nothing yet.
Hypothesis as_new(const Hypothesis& old) {
  Hypothesis spawned;
  spawned.T_map_local = old.T_map_local;
  spawned.associations = old.associations;
  return spawned;
}

}  // namespace

HypothesisSet::HypothesisSet(std::shared_ptr<const MapView> map, const ScorerEnsemble& ensemble,
                             const LocalizerOptions& options, HypothesisListener& listener)
    : map_(std::move(map)),
      index_(*map_),
      ensemble_(ensemble),
      tracking_(options.tracking),
      growth_(options.growth),
      options_(options.hypotheses),
      lead_(options.status.lead()),
      listener_(listener),
      comparison_(map_, options.hypotheses.compared_places, options.tracking.evidence_memory) {}

void HypothesisSet::clear() {
  alive_.clear();
  tree_.clear();
  comparison_.clear();
}

HypothesisId HypothesisSet::new_id() { return std::exchange(next_id_, next_id_.next()); }

void HypothesisSet::end(Live& live, const std::string& reason, HypothesisId merged_into) {
  listener_.ended(live, {reason, merged_into});
  tree_.release(live.leaf);
  live.leaf = {};
}

void HypothesisSet::track(const Observation& observation, double tempering_weight, std::span<const Point> coarse,
                          const Eigen::Vector2d& window) {
  const Pose2& T_local_base = observation.local_map.T_local_base();
  const std::vector<Moved> moved = align_all(observation, coarse, window);
  std::vector<const Hypothesis*> judged;
  for (const Live& live : alive_) judged.push_back(&live.hypothesis);
  std::vector<ScorerEnsemble::Verdict> verdicts = ensemble_.judge_all(judged, observation);
  for (std::size_t k = 0; k < alive_.size(); ++k) {
    Live& live = alive_[k];
    Hypothesis& hypothesis = live.hypothesis;
    const DeadReckoning step{moved[k].predicted, T_local_base, observation.local_map.last_match().covariance};
    hypothesis.T_map_local =
        live.pose.update(step, moved[k].scan, tempering_weight, {tracking_.pose_memory, kPoseJump_m}) *
        T_local_base.inverse();
    live.scan_nat = verdicts[k].nat;
    ++live.updates;
    const double kept = kept_share(tempering_weight, tracking_.evidence_memory);
    hypothesis.log_likelihood = kept * hypothesis.log_likelihood + tempering_weight * verdicts[k].nat;
    ensemble_.fade(hypothesis, tempering_weight);
    ensemble_.remember(hypothesis, verdicts[k].scores, tempering_weight);
    live.scores = std::move(verdicts[k].scores);
    live.inherited_nat *= kept;
    live.ridden_nat *= kept;
    live.compared_nat *= kept;
    if (!verdicts[k].veto.empty()) end(live, "veto by " + verdicts[k].veto);
  }
  std::erase_if(alive_, ended);
  merge(T_local_base);
  compare(observation, tempering_weight);
  prune();
}

std::vector<PlaceComparison::Place> HypothesisSet::places(const Pose2& T_local_base) const {
  std::vector<PlaceComparison::Place> places;
  for (const Live& live : alive_) places.push_back({live.hypothesis.id, live.hypothesis.T_map_local * T_local_base});
  return places;
}

void HypothesisSet::remember(const Observation& observation, KeyframeId keyframe, double tempering_weight,
                             RetrospectiveVerification& retrospective) const {
  const double best_nat = alive_.empty() ? 0 : alive_.front().scan_nat;
  retrospective.remember(observation, keyframe, tempering_weight, best_nat,
                         places(observation.local_map.T_local_base()));
}

void HypothesisSet::compare(const Observation& observation, double tempering_weight) {
  comparison_.add({observation.scans, tempering_weight, places(observation.local_map.T_local_base())});
  take_comparisons();
}

void HypothesisSet::compare_in_retrospect(const Pose2& T_local_base, const RetrospectiveVerification& retrospective) {
  sort_best_first(alive_);
  comparison_.look_back(retrospective.sights(), places(T_local_base));
  take_comparisons();
}

void HypothesisSet::take_comparisons() {
  for (Live& live : alive_) {
    const double against_nat = comparison_.against_nat(live.hypothesis.id);
    live.hypothesis.log_likelihood += live.compared_nat - against_nat;
    live.compared_nat = against_nat;
  }
}

Live* HypothesisSet::at_place_of(const Candidate& candidate, const Pose2& T_local_base) {
  const auto same_place = [&](const Live& live) {
    const Pose2 T_map_base = live.hypothesis.T_map_local * T_local_base;
    return kRenewed.holds(T_map_base, candidate.T_map_base);
  };
  const auto found = std::find_if(alive_.begin(), alive_.end(), same_place);
  return found == alive_.end() ? nullptr : &*found;
}

void HypothesisSet::renew(Live& old, const Pose2& T_map_local, ScorerEnsemble::Verdict verdict,
                          const Observation& observation) const {
  const double gain = verdict.nat - ensemble_.decide(as_new(old.hypothesis), observation);
  if (gain <= kRenewalGain_nat) return;
  old.hypothesis.log_likelihood += gain;
  old.hypothesis.T_map_local = T_map_local;
  old.pose.reset();
  old.scan_nat += gain;
  old.scores = std::move(verdict.scores);
}

HypothesisSet::Spawned HypothesisSet::in_retrospect(Hypothesis hypothesis, const ScorerEnsemble::Verdict& verdict,
                                                    const Observation& observation, double tempering_weight,
                                                    const RetrospectiveVerification& retrospective) const {
  const double share = retrospective.since_newest(tempering_weight);
  ensemble_.remember(hypothesis, verdict.scores, share);
  RetrospectiveVerification::Verdict past = retrospective.verify(hypothesis, observation.local_map);
  const double nat = options_.spawn_nat + share * verdict.nat + past.nat;
  return {std::move(past), nat};
}

double HypothesisSet::surplus_in_retrospect(const Observation& observation, double tempering_weight,
                                            const RetrospectiveVerification& retrospective) const {
  if (alive_.empty() || alive_.front().kidnapped_after.exists()) return 0;
  const Hypothesis best = as_new(alive_.front().hypothesis);
  const Spawned anew =
      in_retrospect(best, ensemble_.judge(best, observation), observation, tempering_weight, retrospective);
  if (anew.past.scans == 0 || anew.past.hopeless || anew.past.kidnapped_after.exists()) return 0;
  return std::max(0.0, anew.nat - alive_.front().hypothesis.log_likelihood - alive_.front().compared_nat);
}

void HypothesisSet::insert(Live live, Spawned spawned, Candidate candidate, HypothesisId from) {
  live.hypothesis.id = new_id();
  live.hypothesis.log_likelihood = spawned.nat;
  live.hypothesis.memories = std::move(spawned.past.memories);
  live.hypothesis.associations = candidate.pairs;
  live.kidnapped_after = spawned.past.kidnapped_after;
  live.inherited_nat = spawned.past.inherited_nat;
  live.leaf = tree_.add({}, std::move(candidate.pairs));
  live.updates = 1;
  listener_.spawned(live, {candidate.origin, candidate.pattern, from});
  alive_.push_back(std::move(live));
}

void HypothesisSet::spawn(std::vector<VerifiedCandidate> candidates, const Observation& observation,
                          double tempering_weight, RetrospectiveVerification& retrospective) {
  const Pose2& T_local_base = observation.local_map.T_local_base();
  std::optional<double> surplus;
  for (VerifiedCandidate& verified : candidates) {
    Candidate& candidate = verified.candidate;
    Live live;
    live.hypothesis.T_map_local = candidate.T_map_base * T_local_base.inverse();
    ScorerEnsemble::Verdict verdict =
        ensemble_.judges_associations() ? ensemble_.judge(live.hypothesis, observation) : std::move(verified.verdict);
    if (!verdict.veto.empty()) {
      listener_.candidate_rejected(verified, "veto by " + verdict.veto);
      continue;
    }
    if (Live* old = at_place_of(candidate, T_local_base)) {
      renew(*old, live.hypothesis.T_map_local, std::move(verdict), observation);
      continue;
    }
    Spawned spawned = in_retrospect(live.hypothesis, verdict, observation, tempering_weight, retrospective);
    if (spawned.past.hopeless) {
      listener_.candidate_rejected(verified,
                                   "would be far behind after " + count_of(spawned.past.scans, "earlier scan"));
      continue;
    }
    if (!surplus) surplus = surplus_in_retrospect(observation, tempering_weight, retrospective);
    if (!spawned.past.kidnapped_after.exists()) spawned.nat -= *surplus;
    live.scan_nat = verdict.nat;
    live.scores = std::move(verdict.scores);
    const std::vector<Pose2> before = std::move(spawned.past.T_map_base);
    insert(std::move(live), std::move(spawned), std::move(candidate));
    retrospective.place(alive_.back().hypothesis.id, before);
  }
  compare_in_retrospect(T_local_base, retrospective);
  prune();
}

double HypothesisSet::settle() {
  const double inherited_nat = alive_.front().inherited_nat;
  for (Live& live : alive_) {
    if (!live.kidnapped_after.exists()) end(live, "the robot was kidnapped");
    live.kidnapped_after = {};
    live.inherited_nat = 0;
    live.hypothesis.log_likelihood -= inherited_nat;
    live.ridden_nat = std::max(0.0, live.ridden_nat - inherited_nat);
  }
  std::erase_if(alive_, ended);
  return inherited_nat;
}

void HypothesisSet::merge(const Pose2& T_local_base) {
  sort_best_first(alive_);
  for (std::size_t a = 0; a < alive_.size(); ++a) {
    if (ended(alive_[a])) continue;
    for (std::size_t b = a + 1; b < alive_.size(); ++b) {
      if (ended(alive_[b])) continue;
      const Pose2 T_a = alive_[a].hypothesis.T_map_local * T_local_base;
      const Pose2 T_b = alive_[b].hypothesis.T_map_local * T_local_base;
      if (kMerge.holds(T_a, T_b))
        end(alive_[b], "same place as hypothesis " + to_string(alive_[a].hypothesis.id), alive_[a].hypothesis.id);
    }
  }
  std::erase_if(alive_, ended);
}

void HypothesisSet::merge_similar() {
  if (growth_.similar_depth == 0) return;
  sort_best_first(alive_);
  const auto tail = [&](const Live& live) {
    std::vector<std::pair<LocalFeatureId, MapFeatureNumber>> last;
    const auto& all = live.hypothesis.associations;
    for (auto it = all.rbegin(); it != all.rend() && int(last.size()) < growth_.similar_depth; ++it)
      last.emplace_back(it->local_feature, it->map_feature);
    return last;
  };
  std::map<std::vector<std::pair<LocalFeatureId, MapFeatureNumber>>, HypothesisId> best_by_tail;
  for (Live& live : alive_) {
    auto last = tail(live);
    const auto is_clutter = [](const auto& pair) { return !pair.second.exists(); };
    if (last.empty() || std::any_of(last.begin(), last.end(), is_clutter)) continue;
    const auto [best, is_new] = best_by_tail.try_emplace(std::move(last), live.hypothesis.id);
    if (!is_new) end(live, "same newest associations as hypothesis " + to_string(best->second), best->second);
  }
  std::erase_if(alive_, ended);
}

void HypothesisSet::prune() {
  sort_best_first(alive_);
  if (alive_.empty()) return;
  const double best = alive_.front().hypothesis.log_likelihood;
  const double most_behind = lead_.kept_within_nat(options_.prune_nat, best);
  for (std::size_t k = 0; k < alive_.size(); ++k) {
    Live& live = alive_[k];
    const double behind = best - live.hypothesis.log_likelihood;
    if (behind > most_behind)
      end(live, fmt::format("worse than the best by {:.1f} nat, more than {:.1f}", behind, most_behind));
    else if (growth_.max_consecutive_not_on_map > 0 && live.consecutive_not_on_map > growth_.max_consecutive_not_on_map)
      end(live, "too many features in a row that are not on the map");
  }
  std::erase_if(alive_, ended);
  prune_surplus();
}

void HypothesisSet::prune_surplus() {
  const auto most = static_cast<std::size_t>(options_.max_hypotheses);
  if (alive_.size() <= most) return;
  sort_best_first(alive_);
  for (std::size_t k = most; k < alive_.size(); ++k) end(alive_[k], "beyond the number of hypotheses kept");
  alive_.resize(most);
}

}  // namespace opal
