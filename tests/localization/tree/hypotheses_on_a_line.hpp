#pragma once

#include "tests/localization/synthetic_scene.hpp"
#include "tests/localization/tree/deaf_listener.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace opal::synthetic {

/// Hears everything.
struct Listener : DeafListener {
  void spawned(const Live& live, const Beginning& beginning) override {
    ++spawns[live.hypothesis.id];
    parents[live.hypothesis.id] = beginning.parent;
  }
  void ended(const Live& live, const Ending& ending) override {
    ++ends[live.hypothesis.id];
    why[live.hypothesis.id] = ending;
  }
  void associated(const Live& live, std::span<const Association> pairs) override {
    pairs_heard[live.hypothesis.id] += static_cast<int>(pairs.size());
  }
  void dissociated(const Live&, const std::vector<LocalFeatureId>& local_features, const std::string&) override {
    dissociations += static_cast<int>(local_features.size());
  }
  void candidate_rejected(const VerifiedCandidate&, const std::string& reason) override { rejected.push_back(reason); }

  std::map<HypothesisId, int> spawns, ends, pairs_heard;
  std::map<HypothesisId, HypothesisId> parents;
  std::map<HypothesisId, Ending> why;
  std::vector<std::string> rejected;
  int dissociations = 0;
};

inline Feature column(double x, double y) { return {"opal:Column", Circle{{x, y}, 0.2}}; }
inline Feature corner(double x, double y) { return {"opal:Corner", OrientedPoint{{x, y}, 0.5, 1.5}}; }

/// Hypotheses along the x axis of a map, about which the only scorer says what it is told for their place.
struct Line {
  explicit Line(const LocalizerOptions& options = {}, const Features& features = {column(0, 50)},
                std::shared_ptr<const HypothesisScorer> second = constant_scorer(0))
      : map(view_of(features)),
        judges(map, {{"told", told(), ScorerRole::decides, 1}, {"second", std::move(second), ScorerRole::observes, 1}}),
        past(map, judges.ensemble, no_earlier_scans(), 1),
        set(map, judges.ensemble, options, listener) {
    see({}, Pose2());
  }
  std::shared_ptr<const HypothesisScorer> told() {
    return std::make_shared<ToldScorer>([this](const Hypothesis& hypothesis, const Observation& seen) {
      const double x_m = (seen.T_map_base(hypothesis.T_map_local)).x();
      return Score{nat_at(x_m), veto_at(x_m), {}};
    });
  }
  /// Without points, hypotheses stay where dead reckoning has them.
  Observation nothing_seen() const { return {local_map, {}}; }
  /// @param features  frame of the base.
  void see(const Features& features, const Pose2& T_odom_base) { local_map.add(sample_of({}, T_odom_base), features); }
  void spawn(const std::vector<double>& places_m, double tempering_weight = 1) {
    std::vector<VerifiedCandidate> candidates;
    for (const double x_m : places_m) {
      candidates.emplace_back();
      candidates.back().candidate.T_map_base = Pose2(x_m, 0, 0);
    }
    set.spawn(std::move(candidates), nothing_seen(), tempering_weight, past);
  }
  void track(double tempering_weight = 1) { set.track(nothing_seen(), tempering_weight, {}, {0, 0}); }
  void grow() { set.grow(all_features_of(local_map), local_map); }
  double nat_of(HypothesisId id) const {
    for (const Live& live : set.alive())
      if (live.hypothesis.id == id) return live.hypothesis.log_likelihood;
    return -1e9;
  }

  std::function<double(double)> nat_at = [](double) { return 10; };
  std::function<std::string(double)> veto_at = [](double) { return ""; };
  std::shared_ptr<const MapView> map;
  Judges judges;
  RetrospectiveVerification past;
  Listener listener;
  LocalMap local_map{{}, nullptr};
  HypothesisSet set;
};

inline LocalizerOptions branching(int branches, bool not_on_map = false) {
  LocalizerOptions options;
  options.growth.max_branches = branches;
  options.growth.branch_not_on_map = not_on_map;
  return options;
}

inline std::set<HypothesisId> ids(std::initializer_list<int> numbers) {
  std::set<HypothesisId> ids;
  for (const int number : numbers) ids.emplace(number);
  return ids;
}

inline bool best_first(const std::vector<Live>& alive) {
  return std::ranges::is_sorted(
      alive, [](const Live& a, const Live& b) { return a.hypothesis.log_likelihood > b.hypothesis.log_likelihood; });
}

inline std::set<HypothesisId> ids_of(const std::vector<Live>& alive) {
  std::set<HypothesisId> ids;
  for (const Live& live : alive) ids.insert(live.hypothesis.id);
  return ids;
}

/// Whoever was heard to begin and not to end is alive, and nobody did either twice.
inline void check_heard(const Listener& listener, const std::vector<Live>& alive) {
  std::set<HypothesisId> heard;
  for (const auto& [id, times] : listener.spawns) {
    CHECK(times == 1);
    if (!listener.ends.contains(id)) heard.insert(id);
  }
  for (const auto& [id, times] : listener.ends) {
    CHECK(times == 1);
    CHECK(listener.spawns.contains(id));
  }
  CHECK(heard == ids_of(alive));
}

}  // namespace opal::synthetic
