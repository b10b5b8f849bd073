#include "tests/localization/tree/hypotheses_on_a_line.hpp"

using namespace opal;
using namespace opal::synthetic;

namespace {

const Pose2 kTruth(6.5, 4.2, 0.4);

/// Hypotheses of a robot that sees a room.
struct InRoom {
  explicit InRoom(const Features& features = room(), std::shared_ptr<const HypothesisScorer> scorer = fit_scorer())
      : map(view_of(features)),
        judges(map, {{"only", std::move(scorer), ScorerRole::decides, 1}}),
        past(map, judges.ensemble, {}, 0.99),
        set(map, judges.ensemble, {}, listener) {}
  void spawn(const std::vector<Pose2>& poses, double tempering_weight = 1) {
    std::vector<VerifiedCandidate> candidates;
    for (const Pose2& pose : poses) {
      candidates.emplace_back();
      candidates.back().candidate.T_map_base = pose;
      candidates.back().verdict = judges.ensemble.judge(robot.at(pose), robot.observation());
    }
    set.spawn(std::move(candidates), robot.observation(), tempering_weight, past);
  }
  void track(double tempering_weight = 1, const Eigen::Vector2d& window = {0, 0}) {
    set.track(robot.observation(), tempering_weight, robot.observation().scans.front().points, window);
  }
  Pose2 pose_of(std::size_t rank) const {
    return set.alive()[rank].hypothesis.T_map_local * robot.local_map().T_local_base();
  }

  std::shared_ptr<const MapView> map;
  Judges judges;
  RetrospectiveVerification past;
  Listener listener;
  HypothesisSet set;
  Robot robot{map, kTruth};
};

}  // namespace

TEST_CASE("hypotheses that the scan brings to one place become one, and the end names who goes on") {
  InRoom scene;
  scene.spawn({kTruth * Pose2(0.22, 0, 0), kTruth * Pose2(-0.22, 0, 0)});
  REQUIRE(scene.set.alive().size() == 2);
  scene.track();
  REQUIRE(scene.set.alive().size() == 1);
  CHECK(distance_m(scene.pose_of(0), kTruth) < 0.05);
  REQUIRE(scene.listener.ends.size() == 1);
  CHECK(scene.listener.why.begin()->second.merged_into == scene.set.alive().front().hypothesis.id);
  check_heard(scene.listener, scene.set.alive());
}

TEST_CASE("a hypothesis follows a robot that drives") {
  InRoom scene;
  scene.spawn({kTruth});
  for (int k = 0; k < 10; ++k) {
    scene.robot.drive_to(scene.robot.T_map_base() * Pose2(0.2, 0.02, 0.1));
    scene.track(0.2);
    REQUIRE(scene.set.alive().size() == 1);
    CHECK(distance_m(scene.pose_of(0), scene.robot.T_map_base()) < 0.05);
  }
}

TEST_CASE("where dead reckoning failed by less than the window, a hypothesis is found again") {
  InRoom scene;
  scene.spawn({kTruth * Pose2(0.3, -0.3, 0.3)});
  scene.track(1, {0.5, 0.35});
  REQUIRE(scene.set.alive().size() == 1);
  CHECK(distance_m(scene.pose_of(0), kTruth) < 0.05);
  CHECK(angle_between_rad(scene.pose_of(0), kTruth) < 0.02);
}

TEST_CASE("a candidate that the scans before speak against is rejected") {
  InRoom scene;
  scene.robot = Robot(scene.map, Pose2(2, 4, 0));
  for (int k = 0; k < 10; ++k) {
    scene.robot.drive_to(scene.robot.T_map_base() * Pose2(0.4, 0.05, 0.02));
    scene.past.remember(scene.robot.observation(), KeyframeId(k), 1, 2.9);
  }
  scene.spawn({Pose2(2, 2, 0.8), scene.robot.T_map_base()});
  REQUIRE(scene.set.alive().size() == 1);
  CHECK(distance_m(scene.pose_of(0), scene.robot.T_map_base()) < 0.05);
  CHECK(scene.listener.rejected.size() == 1);
}

namespace {

/// What is seen for the first time counts most.
struct FirstSightScorer : CountingScorer {
  Score score(const Hypothesis& hypothesis, const Observation& seen, const MapView& map,
              const ScorerMemory* memory) const override {
    Score score = CountingScorer::score(hypothesis, seen, map, memory);
    score.log_likelihood = 3 / (1 + score.log_likelihood);
    return score;
  }
  void fade(ScorerMemory&, double) const override {}
};

/// Two equal rooms; one of them was tracked for a while, the other one is spawned then.
struct Latecomer {
  explicit Latecomer(std::shared_ptr<const HypothesisScorer> scorer) : scene(twins(), std::move(scorer)) {
    scene.robot = Robot(scene.map, Pose2(2, 4, 0));
    scene.spawn({scene.robot.T_map_base()});
    for (int k = 0; k < 20; ++k) {
      scene.robot.drive_to(scene.robot.T_map_base() * Pose2(0.2, 0.02, 0.02));
      scene.track(0.3);
      scene.past.remember(scene.robot.observation(), KeyframeId(k), 0.3, scene.set.alive().front().scan_nat);
    }
    scene.spawn({T_map_second * scene.robot.T_map_base()}, 0.3);
  }
  static Features twins() {
    Features features = room();
    for (const Feature& feature : moved(T_map_second, room())) features.push_back(feature);
    return features;
  }
  double nat_of(HypothesisId id) const {
    const auto& alive = scene.set.alive();
    const auto found = std::ranges::find_if(alive, [&](const Live& live) { return live.hypothesis.id == id; });
    REQUIRE(found != alive.end());
    return found->hypothesis.log_likelihood;
  }
  static inline const Pose2 T_map_second{20, 0, 0};
  InRoom scene;
};

}  // namespace

TEST_CASE("who comes late has no more than who was right all along, and does not start with nothing") {
  const Latecomer by_fit(fit_scorer());
  CHECK(by_fit.nat_of(HypothesisId(1)) <= by_fit.nat_of(HypothesisId(0)) + 0.05);
  CHECK(by_fit.nat_of(HypothesisId(1)) > 0.5 * by_fit.nat_of(HypothesisId(0)));
}

TEST_CASE("who comes late has no advantage of seeing in few large pieces what was tracked in many small ones") {
  const Latecomer by_first_sight(std::make_shared<FirstSightScorer>());
  CHECK(by_first_sight.nat_of(HypothesisId(1)) <= by_first_sight.nat_of(HypothesisId(0)) + 0.05);
}
