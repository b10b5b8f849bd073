#include "tests/localization/synthetic_scene.hpp"
#include "tests/localization/tree/deaf_listener.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Counts, and keeps what was taken back.
struct CountingListener : DeafListener {
  int spawns = 0;
  std::vector<std::vector<LocalFeatureId>> taken_back;
  void spawned(const Live&, const Beginning&) override { ++spawns; }
  void dissociated(const Live&, const std::vector<LocalFeatureId>& features, const std::string&) override {
    taken_back.push_back(features);
  }
};

/// Hypotheses in a map that sees `local` features from the origin of its local frame.
struct Growing {
  Growing(const Features& mapped, const LocalizerOptions& options)
      : map(view_of(mapped)),
        judges(map, {{"constant", constant_scorer(1), ScorerRole::decides, 1}}),
        past(map, judges.ensemble, no_earlier_scans(), 1),
        set(map, judges.ensemble, options, listener) {
    see({});
  }
  void see(const Features& local) { local_map.add(sample_of({}, Pose2()), local); }
  void spawn_at(const Pose2& T_map_base) {
    VerifiedCandidate candidate;
    candidate.candidate.T_map_base = T_map_base;
    set.spawn({candidate}, Observation{local_map, {}}, 1, past);
  }
  void grow() { set.grow(all_features_of(local_map), local_map); }
  std::shared_ptr<const MapView> map;
  Judges judges;
  RetrospectiveVerification past;
  CountingListener listener;
  LocalMap local_map{{}, nullptr};
  HypothesisSet set;
};

Feature corner_at(double x, double y, double heading_rad) {
  return {"opal:Corner", OrientedPoint{{x, y}, heading_rad, 1.5}};
}

/// Whether a hypothesis takes the corner that it sees for the mapped one at (4, 0), which looks along x.
bool is_taken_for_mapped(const Feature& seen) {
  Growing growing({corner_at(4, 0, 0)}, {});
  growing.spawn_at(Pose2());
  growing.see({seen});
  growing.grow();
  return growing.set.alive().front().hypothesis.associations.front().map_feature.exists();
}

}  // namespace

TEST_CASE("a local feature is taken for a mapped one that is near and looks the same way, not for one of the two") {
  CHECK(is_taken_for_mapped(corner_at(4.2, 0.2, 0.1)));
  CHECK_FALSE(is_taken_for_mapped(corner_at(4.1, 0, 0.3)));
  CHECK_FALSE(is_taken_for_mapped(corner_at(4.1, 0, -0.3)));
  CHECK_FALSE(is_taken_for_mapped(corner_at(4.4, 0.3, 0)));
  CHECK_FALSE(is_taken_for_mapped({"opal:Doorpost", OrientedPoint{{4, 0}, 0, 1.5}}));
}

TEST_CASE("while features are taken in one by one, no more hypotheses live than are kept") {
  LocalizerOptions options;
  options.growth.max_branches = 1;
  options.growth.branch_not_on_map = true;
  options.hypotheses.max_hypotheses = 2;
  Features corners;
  for (int k = 0; k < 6; ++k) corners.push_back(corner_at(2 + 2 * k, 0, 0));
  Growing growing(corners, options);
  growing.spawn_at(Pose2());
  growing.see(corners);
  growing.grow();
  CHECK(growing.set.alive().size() == 2);
  CHECK(growing.listener.spawns <= 1 + 2 * 6);  // each of two branches once per feature
}

TEST_CASE("each hypothesis takes back what no longer fits it, and not what fits another one no longer") {
  const Features corners{corner_at(4, 0, 0), corner_at(4, 3, 0)};
  Growing growing(corners, {});
  growing.spawn_at(Pose2());
  growing.see(corners);
  growing.grow();
  growing.spawn_at(Pose2(20, 0, 0));
  growing.grow();
  REQUIRE(growing.set.alive().size() == 2);
  growing.set.forget(growing.local_map);
  CHECK(growing.listener.taken_back.empty());
  growing.local_map.keep_only({LocalFeatureId(0)});
  growing.set.forget(growing.local_map);
  CHECK(growing.listener.taken_back == std::vector<std::vector<LocalFeatureId>>(2, {LocalFeatureId(1)}));
}

TEST_CASE("how far a scan moves and turns a hypothesis depends on how much dead reckoning is told to weigh") {
  const auto map = view_of(room());
  const Pose2 truth(5, 4, 0.3), guess = truth * Pose2(0.08, 0.05, 0.04);
  const Robot robot(map, truth);
  const auto tracked = [&](double prior_position, double prior_heading) {
    LocalizerOptions options;
    options.tracking.prior_position = prior_position;
    options.tracking.prior_heading = prior_heading;
    Judges judges(map, {{"constant", constant_scorer(1), ScorerRole::decides, 1}});
    RetrospectiveVerification past(map, judges.ensemble, no_earlier_scans(), 1);
    CountingListener listener;
    HypothesisSet set(map, judges.ensemble, options, listener);
    VerifiedCandidate candidate;
    candidate.candidate.T_map_base = guess;
    set.spawn({candidate}, robot.observation(), 1, past);
    set.track(robot.observation(), 1, {}, {0, 0});
    return set.alive().front().hypothesis.T_map_local * robot.local_map().T_local_base();
  };
  CHECK(distance_m(tracked(0, 0), truth) < 0.02);
  CHECK(angle_between_rad(tracked(0, 0), truth) < 0.01);
  CHECK(distance_m(tracked(1e6, 0), guess) < 0.001);
  CHECK(angle_between_rad(tracked(0, 1e6), guess) < 0.001);
  CHECK(angle_between_rad(tracked(1e6, 1e6), guess) < 0.001);
}

TEST_CASE("the tree has the nodes from the leaves that are alive to their roots, and no others, whatever is seen") {
  LocalizerOptions options;
  options.growth.max_branches = GENERATE(1, 2);
  options.growth.branch_not_on_map = GENERATE(false, true);
  options.growth.max_consecutive_not_on_map = 2;
  options.hypotheses.max_hypotheses = 5;
  Features corners;
  for (int k = 0; k < 6; ++k) corners.push_back(corner_at(2 + 0.3 * k, 0, 0));
  Growing growing(corners, options);
  for (int k = 0; k < 12; ++k) {
    growing.spawn_at(Pose2(3.0 * (k % 4), 0, 0));
    growing.see({corner_at(2 + 1.5 * (k % 3), 0.1, 0), corner_at(30 + 2 * k, 0, 0)});
    growing.grow();
    if (k % 4 == 3) growing.local_map.keep_only({growing.local_map.features().back().id});
    growing.set.forget(growing.local_map);
    std::set<NodeId> needed;
    for (const Live& live : growing.set.alive()) {
      for (NodeId id = live.leaf; id.exists(); id = growing.set.tree().node(id).parent) needed.insert(id);
    }
    CHECK(growing.set.tree().size() == needed.size());
  }
}
