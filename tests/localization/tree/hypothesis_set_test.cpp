#include "tests/localization/tree/hypotheses_on_a_line.hpp"

#include <random>

using namespace opal;
using namespace opal::synthetic;

namespace {

constexpr double kSpawn_nat = HypothesesOptions{}.spawn_nat, kPrune_nat = HypothesesOptions{}.prune_nat;

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
