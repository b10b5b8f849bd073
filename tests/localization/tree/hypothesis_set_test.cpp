#include "tests/localization/synthetic_scene.hpp"
#include "tests/localization/tree/deaf_listener.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace opal;
using namespace opal::synthetic;

namespace {

constexpr double kSpawn_nat = HypothesesOptions{}.spawn_nat, kPrune_nat = HypothesesOptions{}.prune_nat;

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

Feature column(double x, double y) { return {"opal:Column", Circle{{x, y}, 0.2}}; }
Feature corner(double x, double y) { return {"opal:Corner", OrientedPoint{{x, y}, 0.5, 1.5}}; }

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

std::set<HypothesisId> ids(std::initializer_list<int> numbers) {
  std::set<HypothesisId> ids;
  for (const int number : numbers) ids.emplace(number);
  return ids;
}

bool best_first(const std::vector<Live>& alive) {
  return std::ranges::is_sorted(
      alive, [](const Live& a, const Live& b) { return a.hypothesis.log_likelihood > b.hypothesis.log_likelihood; });
}

std::set<HypothesisId> ids_of(const std::vector<Live>& alive) {
  std::set<HypothesisId> ids;
  for (const Live& live : alive) ids.insert(live.hypothesis.id);
  return ids;
}

/// Whoever was heard to begin and not to end is alive, and nobody did either twice.
void check_heard(const Listener& listener, const std::vector<Live>& alive) {
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

/// Says of a hypothesis' last association what it remembers of it.
struct AssociationMemory : CountingScorer {
  Score score(const Hypothesis& hypothesis, const Observation&, const MapView&, const ScorerMemory*) const override {
    auto seen = std::make_shared<CountMemory>();
    seen->count = hypothesis.associations.empty() ? 0 : 100 + hypothesis.associations.back().map_feature.number();
    return {0, {}, {}, std::move(seen)};
  }
  void fade(ScorerMemory&, double) const override {}
};

LocalizerOptions branching(int branches, bool not_on_map = false) {
  LocalizerOptions options;
  options.growth.max_branches = branches;
  options.growth.branch_not_on_map = not_on_map;
  return options;
}

}  // namespace

TEST_CASE("a candidate becomes a hypothesis with what the scan says and the price of being new") {
  Line line;
  line.spawn({5});
  REQUIRE(line.set.alive().size() == 1);
  const Live& live = line.set.alive().front();
  CHECK(live.hypothesis.log_likelihood == Approx(kSpawn_nat + 10));
  CHECK(live.scan_nat == 10);
  CHECK(live.hypothesis.T_map_local.x() == Approx(5));
  CHECK_FALSE(line.listener.parents.at(live.hypothesis.id).exists());
}

TEST_CASE("candidates at one place are one hypothesis, in one search or in two") {
  Line line;
  line.spawn({5, 5.2, 9});
  CHECK(line.set.alive().size() == 2);
  line.spawn({5.1, 8.9, 20});
  CHECK(line.set.alive().size() == 3);
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("a candidate that is clearly better aligned moves the hypothesis at its place, and keeps its number") {
  Line line;
  line.nat_at = [](double x_m) { return x_m > 5.1 ? 12 : 10; };
  line.spawn({5});
  line.spawn({5.2});
  REQUIRE(line.set.alive().size() == 1);
  CHECK(line.set.alive().front().hypothesis.id == HypothesisId(0));
  CHECK(line.set.alive().front().hypothesis.T_map_local.x() == Approx(5.2));
  CHECK(line.nat_of(HypothesisId(0)) == Approx(kSpawn_nat + 12));
  CHECK(line.set.alive().front().scan_nat == 12);
  CHECK(line.set.alive().front().scores.front().log_likelihood == 12);
}

TEST_CASE("a candidate that is hardly better aligned moves nobody") {
  Line line;
  line.nat_at = [](double x_m) { return x_m > 5.1 ? 10.2 : 10; };
  line.spawn({5});
  line.spawn({5.2});
  CHECK(line.set.alive().front().hypothesis.T_map_local.x() == Approx(5));
  CHECK(line.nat_of(HypothesisId(0)) == Approx(kSpawn_nat + 10));
}

TEST_CASE("evidence adds up by its weight, and what was gathered fades by the same") {
  LocalizerOptions options;
  options.tracking.evidence_memory = 0.9;
  Line line(options);
  line.spawn({5});
  const double before = line.nat_of(HypothesisId(0));
  line.track(0.5);
  CHECK(line.nat_of(HypothesisId(0)) == Approx(0.95 * before + 0.5 * 10));
}

TEST_CASE("who is worse than the best by more than the limit ends, and nobody else") {
  Line line;
  line.nat_at = [](double x_m) { return 20 - x_m; };
  line.spawn({0, kPrune_nat - 0.1, kPrune_nat + 0.5});
  CHECK(ids_of(line.set.alive()) == ids({0, 1}));
  CHECK(line.listener.ends.size() == 1);
  CHECK_FALSE(line.listener.why.at(HypothesisId(2)).merged_into.exists());
}

TEST_CASE("who is within the lead that the status asks for stays, however much evidence there is") {
  LocalizerOptions options;
  options.status.localized_lead = 0.2;
  const double most_nat = GENERATE(1000, 15);
  options.status.localized_lead_nat = most_nat;
  Line line(options);
  const double best_nat = 100, lead_nat = std::min(0.2 * (best_nat + kSpawn_nat), most_nat);
  line.nat_at = [&](double x_m) { return best_nat - x_m; };
  line.spawn({0, lead_nat - 0.5, lead_nat + 0.5});
  CHECK(ids_of(line.set.alive()) == ids({0, 1}));
}

TEST_CASE("a hypothesis that falls behind while it is tracked ends") {
  Line line;
  line.spawn({0, 10});
  line.nat_at = [](double x_m) { return x_m > 5 ? -1 : 2; };
  line.track();
  CHECK(line.set.alive().size() == 2);
  line.track();
  line.track();
  CHECK(ids_of(line.set.alive()) == ids({0}));
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("there are never more hypotheses than allowed, and the best ones stay") {
  LocalizerOptions options;
  options.hypotheses.max_hypotheses = 3;
  Line line(options);
  line.nat_at = [](double x_m) { return 10 + 0.1 * x_m; };
  line.spawn({0, 10, 20, 30, 40});
  CHECK(ids_of(line.set.alive()) == ids({2, 3, 4}));
  line.spawn({50});
  CHECK(ids_of(line.set.alive()) == ids({3, 4, 5}));
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("numbers of hypotheses are never used again, not even when all begins anew") {
  Line line;
  line.spawn({0, 10});
  line.set.clear();
  CHECK(line.set.alive().empty());
  CHECK(line.set.tree().size() == 0);
  line.spawn({0, 10});
  CHECK(ids_of(line.set.alive()) == ids({2, 3}));
}

TEST_CASE("a vetoed candidate is rejected with the reason") {
  Line line;
  line.veto_at = [](double x_m) { return x_m > 5 ? "behind a wall" : ""; };
  line.spawn({0, 10});
  CHECK(line.set.alive().size() == 1);
  CHECK(line.listener.rejected == std::vector<std::string>{"veto by told: behind a wall"});
  CHECK(line.listener.ends.empty());
}

TEST_CASE("a hypothesis that is vetoed ends, even the best one") {
  Line line;
  line.spawn({0, 10});
  line.veto_at = [](double x_m) { return x_m < 5 ? "behind a wall" : ""; };
  line.track();
  CHECK(ids_of(line.set.alive()) == ids({1}));
  CHECK(line.listener.why.at(HypothesisId(0)).reason == "veto by told: behind a wall");
}

TEST_CASE("every beginning and every end is heard once, and the best hypothesis stands first, whatever happens") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> nat(-2, 4), place_m(0, 30);
  LocalizerOptions options = branching(2, true);
  options.hypotheses.max_hypotheses = 6;
  options.growth.similar_depth = 3;
  options.growth.max_consecutive_not_on_map = 3;
  Line line(options, {column(1, 1), column(1.4, 1), column(11, 1), column(20, 1), column(20.3, 1.2)});
  line.nat_at = [&](double) { return nat(random); };
  line.veto_at = [&](double) { return random() % 20 == 0 ? "by chance" : ""; };
  for (int k = 1; k < 60; ++k) {
    line.see({column(place_m(random), 1)}, Pose2(0.3 * k, 0, 0));
    line.track(0.5);
    CHECK(best_first(line.set.alive()));
    line.spawn({place_m(random), place_m(random)});
    CHECK(best_first(line.set.alive()));
    line.set.forget(line.local_map);
    line.grow();
    CHECK(best_first(line.set.alive()));
    CHECK(line.set.alive().size() <= 6);
    check_heard(line.listener, line.set.alive());
  }
  CHECK(line.listener.ends.size() > 10);
}

TEST_CASE("a feature with two mapped ones near it makes two hypotheses: one goes on, the other begins") {
  Line line(branching(2), {column(0.8, 0), column(1.2, 0), column(9, 9)});
  line.spawn({0});
  line.see({column(1.02, 0)}, Pose2());
  line.grow();
  REQUIRE(line.set.alive().size() == 2);
  std::set<MapFeatureNumber> paired;
  for (const Live& live : line.set.alive()) {
    REQUIRE(live.hypothesis.associations.size() == 1);
    paired.insert(live.hypothesis.associations.front().map_feature);
    CHECK(line.set.tree().branch(live.leaf).size() == 1);
  }
  CHECK(paired == std::set{MapFeatureNumber(0), MapFeatureNumber(1)});
  CHECK(line.listener.parents.at(HypothesisId(1)) == HypothesisId(0));
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("hypotheses that branched remember for themselves from then on") {
  LocalizerOptions options = branching(2);
  options.growth.register_by_associations = true;  // else they are at one place, and one again
  Line line(options, {corner(0.7, 0), corner(1.3, 0)}, std::make_shared<AssociationMemory>());
  line.spawn({0});
  line.see({corner(1.02, 0)}, Pose2());
  line.grow();
  REQUIRE(line.set.alive().size() == 2);
  const Hypothesis &a = line.set.alive()[0].hypothesis, &b = line.set.alive()[1].hypothesis;
  CHECK(a.memories.of(1) == b.memories.of(1));
  const double before = count_of(a, 1);
  line.track();
  REQUIRE(line.set.alive().size() == 2);
  for (const Live& live : line.set.alive())
    CHECK(count_of(live.hypothesis, 1) == before + 100 + live.hypothesis.associations.back().map_feature.number());
}

TEST_CASE("branches that stay at one place are one hypothesis again with the next scan") {
  Line line(branching(2), {column(0.8, 0), column(1.2, 0)});
  line.spawn({0});
  line.see({column(1.02, 0)}, Pose2());
  line.grow();
  REQUIRE(line.set.alive().size() == 2);
  line.track();
  CHECK(line.set.alive().size() == 1);
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("a feature with nothing mapped near it is not on the map, and is said once") {
  Line line({}, {column(50, 0)});
  line.spawn({0});
  line.see({column(1, 0)}, Pose2());
  line.grow();
  line.grow();
  REQUIRE(line.set.alive().size() == 1);
  REQUIRE(line.set.alive().front().hypothesis.associations.size() == 1);
  CHECK_FALSE(line.set.alive().front().hypothesis.associations.front().map_feature.exists());
  CHECK(line.listener.pairs_heard.at(HypothesisId(0)) == 1);
}

TEST_CASE("tracking lets scorers' memories fade before it adds to them") {
  Line line({}, {column(0, 50)}, std::make_shared<CountingScorer>());
  line.spawn({0});
  CHECK(count_of(line.set.alive().front().hypothesis, 1) == 1);
  line.track(0.5);
  CHECK(count_of(line.set.alive().front().hypothesis, 1) == Approx(0.75 * 1 + 0.5));
}

TEST_CASE("associations move a hypothesis where they fix its pose, and nowhere else") {
  LocalizerOptions options = branching(2);
  options.growth.register_by_associations = true;
  const auto place_after = [&](const Feature& mapped, const Feature& seen) {
    Line line(options, {mapped});
    line.spawn({0});
    line.see({seen}, Pose2());
    line.grow();
    return line.set.alive().at(0).hypothesis.T_map_local.x();
  };
  CHECK(place_after(corner(1.3, 0), corner(1, 0)) == Approx(0.3));
  CHECK(place_after(column(1.3, 0), column(1, 0)) == 0);  // it may be turned about the column
}

TEST_CASE("what the local map has forgotten, hypotheses forget") {
  Line line({}, {column(1, 0)});
  line.spawn({0});
  line.see({column(1, 0)}, Pose2());
  line.grow();
  line.set.forget(line.local_map);
  CHECK(line.set.alive().front().hypothesis.associations.size() == 1);
  line.local_map.keep_only({});
  line.set.forget(line.local_map);
  CHECK(line.set.alive().front().hypothesis.associations.empty());
  CHECK(line.listener.dissociations == 1);
}

TEST_CASE("a branch of too many features that are not on the map ends") {
  LocalizerOptions options = branching(1, true);
  options.growth.max_consecutive_not_on_map = 2;
  Line line(options, {column(50, 0)});
  line.spawn({0});
  line.see({column(1, 0), column(2, 0), column(3, 0)}, Pose2());
  line.grow();
  CHECK(line.set.alive().empty());
  CHECK(line.set.tree().size() == 0);
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("too many features that are not on the map end a hypothesis that never branches, too") {
  LocalizerOptions options;
  options.growth.max_consecutive_not_on_map = 2;
  Line line(options, {column(50, 0)});
  line.spawn({0});
  line.see({column(1, 0), column(2, 0), column(3, 0)}, Pose2());
  line.grow();
  line.track();
  CHECK(line.set.alive().empty());
}

TEST_CASE("once a kidnapping is settled, those without it end and what was taken over is gone") {
  Line line;
  line.nat_at = [](double x_m) { return x_m > 5 ? 12 : 10; };
  line.spawn({0});
  line.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(5), 4});
  line.spawn({10, 20});
  REQUIRE(line.set.alive().size() == 3);
  CHECK(line.set.alive().front().kidnapped_after == KeyframeId(5));
  CHECK(line.nat_of(HypothesisId(1)) == Approx(kSpawn_nat + 12 + 4));
  CHECK(line.set.settle() == Approx(4));
  CHECK(ids_of(line.set.alive()) == ids({1, 2}));
  CHECK(line.listener.why.at(HypothesisId(0)).reason == "the robot was kidnapped");
  for (const Live& live : line.set.alive()) {
    CHECK_FALSE(live.kidnapped_after.exists());
    CHECK(live.inherited_nat == 0);
    CHECK(live.hypothesis.log_likelihood == Approx(kSpawn_nat + 12));
  }
  CHECK(best_first(line.set.alive()));
  check_heard(line.listener, line.set.alive());
}

TEST_CASE("what is taken over from a kidnapping fades like everything that was gathered") {
  LocalizerOptions options;
  options.tracking.evidence_memory = 0.9;
  Line line(options);
  line.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(5), 4});
  line.spawn({10});
  line.track(0.5);
  CHECK(line.set.alive().front().inherited_nat == Approx(0.95 * 4));
}

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
