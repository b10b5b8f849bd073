#include "tests/localization/synthetic_scene.hpp"
#include "tests/localization/tree/deaf_listener.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace opal;
using namespace opal::synthetic;

namespace {

struct Parents : DeafListener {
  void spawned(const Live&, const Beginning& beginning) override {
    parents.push_back(beginning.parent);
    origins.push_back(beginning.origin);
  }
  std::vector<HypothesisId> parents;
  std::vector<Origin> origins;
};

/// Hypotheses on storeys that lie at x = 0, 100, 200, all of them in a lift.
struct Lift {
  explicit Lift(const LocalizerOptions& options = {}) : set(map, judges.ensemble, options, listener) {
    local_map.add(Sample{}, {});
    std::vector<VerifiedCandidate> candidates(1);
    set.spawn(std::move(candidates), observation(), 1, past);
  }
  Observation observation() const { return {local_map, {}}; }
  static std::vector<Pose2> elsewhere(const Pose2& T_map_base) {
    std::vector<Pose2> poses;
    for (const double x_m : {0.0, 100.0, 200.0})
      if (std::abs(T_map_base.x() - x_m) > 50) poses.emplace_back(x_m, T_map_base.y(), T_map_base.heading_rad());
    return poses;
  }
  void ride() { set.carry(elsewhere, local_map.T_local_base()); }
  double all_nat() const {
    double sum = 0;
    for (const Live& live : set.alive()) sum += std::exp(live.hypothesis.log_likelihood);
    return std::log(sum);
  }
  double share_at(double x_m) const {
    double sum = 0, here = 0;
    for (const Live& live : set.alive()) {
      const double weight = std::exp(live.hypothesis.log_likelihood);
      sum += weight;
      if (std::abs(live.hypothesis.T_map_local.x() - x_m) < 1) here += weight;
    }
    return here / sum;
  }

  Parents listener;
  std::shared_ptr<const MapView> map = view_of({{"opal:Column", Circle{{0, 50}, 0.2}}});
  std::function<double(double)> nat_at = [](double) { return 1; };
  std::shared_ptr<const HypothesisScorer> told =
      std::make_shared<ToldScorer>([this](const Hypothesis& hypothesis, const Observation& seen) {
        return Score{nat_at(seen.T_map_base(hypothesis.T_map_local).x()), {}, {}};
      });
  Judges judges{map,
                {{"told", told, ScorerRole::decides, 1},
                 {"counts", std::make_shared<CountingScorer>(), ScorerRole::observes, 1}}};
  RetrospectiveVerification past{map, judges.ensemble, no_earlier_scans(), 1};
  LocalMap local_map{{}, nullptr};
  HypothesisSet set;
};

}  // namespace

TEST_CASE("a ride shares the weight of a hypothesis alike among all storeys, and loses nothing of it") {
  Lift lift;
  const double before_nat = lift.set.alive().front().hypothesis.log_likelihood;
  lift.ride();
  REQUIRE(lift.set.alive().size() == 3);
  for (const double x_m : {0.0, 100.0, 200.0}) CHECK(lift.share_at(x_m) == Approx(1.0 / 3));
  CHECK(lift.all_nat() == Approx(before_nat));
  CHECK(lift.listener.parents.size() == 3);
  CHECK(lift.listener.parents[1] == lift.set.alive().front().hypothesis.id);
  CHECK(lift.listener.origins[1] == Origin::ride);
}

TEST_CASE("a second ride makes no further hypotheses: it mixes those that there are") {
  Lift lift;
  lift.ride();
  lift.ride();
  REQUIRE(lift.set.alive().size() == 3);
  for (const double x_m : {0.0, 100.0, 200.0}) CHECK(lift.share_at(x_m) == Approx(1.0 / 3));
}

TEST_CASE("hypotheses outside of lifts stay as they are") {
  Lift lift;
  const double before_nat = lift.set.alive().front().hypothesis.log_likelihood;
  lift.set.carry([](const Pose2&) { return std::vector<Pose2>(); }, lift.local_map.T_local_base());
  CHECK(lift.set.alive().size() == 1);
  CHECK(lift.set.alive().front().hypothesis.log_likelihood == before_nat);
}

TEST_CASE("evidence from before a ride fades like all that was gathered") {
  Lift lift;
  lift.ride();
  const double before_nat = lift.set.alive().front().ridden_nat;
  for (int k = 0; k < 10; ++k) lift.set.track(lift.observation(), 1, {}, Eigen::Vector2d::Zero());
  CHECK(lift.set.alive().front().ridden_nat == Approx(before_nat * std::pow(TrackingOptions{}.evidence_memory, 10)));
}

TEST_CASE("a second ride leaves no evidence that is not from before it") {
  Lift lift;
  lift.ride();
  lift.set.track(lift.observation(), 1, {}, Eigen::Vector2d::Zero());
  lift.ride();
  for (const Live& live : lift.set.alive()) CHECK(live.ridden_nat == Approx(live.hypothesis.log_likelihood));
}

TEST_CASE("storeys of unequal weight weigh alike after a ride that may lead to any of them, and as much in all") {
  Lift lift;
  lift.ride();
  lift.nat_at = [](double x_m) { return 0.02 * x_m - 1; };
  lift.set.track(lift.observation(), 1, {}, Eigen::Vector2d::Zero());
  REQUIRE(lift.share_at(200) > 5 * lift.share_at(0));
  const double before_nat = lift.all_nat();
  lift.ride();
  REQUIRE(lift.set.alive().size() == 3);
  CHECK(lift.all_nat() == Approx(before_nat));
  for (const double x_m : {0.0, 100.0, 200.0}) CHECK(lift.share_at(x_m) == Approx(1.0 / 3));
}

TEST_CASE("what scorers had seen before a ride is forgotten on all storeys, also where the ride began") {
  Lift lift;
  for (int k = 0; k < 5; ++k) lift.set.track(lift.observation(), 1, {}, Eigen::Vector2d::Zero());
  REQUIRE(count_of(lift.set.alive().front().hypothesis, 1) > 1);
  lift.ride();
  lift.set.track(lift.observation(), 1, {}, Eigen::Vector2d::Zero());
  REQUIRE(lift.set.alive().size() == 3);
  for (const Live& live : lift.set.alive()) CHECK(count_of(live.hypothesis, 1) == 1);
}

TEST_CASE("who comes from a ride was kidnapped when the one was that rode, and inherits the same") {
  Lift lift;
  lift.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(9), 20});
  lift.set.clear();
  lift.set.spawn(std::vector<VerifiedCandidate>(1), lift.observation(), 1, lift.past);
  REQUIRE(lift.set.alive().front().kidnapped_after == KeyframeId(9));
  lift.ride();
  REQUIRE(lift.set.alive().size() == 3);
  for (const Live& live : lift.set.alive()) {
    CHECK(live.kidnapped_after == KeyframeId(9));
    CHECK(live.inherited_nat == 20);
  }
}

TEST_CASE("a ride leaves no more hypotheses than are kept") {
  LocalizerOptions options;
  options.hypotheses.max_hypotheses = 2;
  Lift lift(options);
  lift.ride();
  CHECK(lift.set.alive().size() == 2);
}

TEST_CASE("a place that shares its weight with others stands behind one that does not ride, if it has less then") {
  Lift lift;
  lift.ride();
  lift.nat_at = [](double x_m) { return 0.01 * x_m; };
  lift.set.track(lift.observation(), 1, {}, Eigen::Vector2d::Zero());
  REQUIRE(lift.set.alive().front().hypothesis.T_map_local.x() == Approx(200));
  const auto from_200 = [](const Pose2& T_map_base) {
    if (T_map_base.x() < 150) return std::vector<Pose2>();
    return std::vector<Pose2>{Pose2(300, 0, 0), Pose2(400, 0, 0), Pose2(500, 0, 0)};
  };
  lift.set.carry(from_200, lift.local_map.T_local_base());
  CHECK(lift.set.alive().size() == 6);
  CHECK(lift.set.alive().front().hypothesis.T_map_local.x() == Approx(100));
}
