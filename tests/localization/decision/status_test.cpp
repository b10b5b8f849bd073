#include "tests/localization/decision/made_status.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace opal;

namespace {

double sum_of(const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); }

double total(const PoseEstimate& estimate) {
  double sum = estimate.probability + estimate.none;
  for (const auto& alternative : estimate.alternatives) sum += alternative.probability;
  return sum;
}

}  // namespace

TEST_CASE("without hypotheses the robot is searching and has no pose") {
  Answer answer;
  const PoseEstimate estimate = answer.to({});
  CHECK(estimate.status == Status::searching);
  CHECK_FALSE(estimate.has_pose);
  CHECK(estimate.none == 1);
  CHECK(estimate.probability == 0);
  CHECK(answer.estimator.belief().why == "no hypothesis is left");
}

TEST_CASE("one place that is hardly better than none is searched on") {
  Answer answer;
  PoseEstimate estimate;
  for (int k = 0; k < 10; ++k) estimate = answer.to({hypothesis(1, kHere, 1)});
  CHECK(estimate.has_pose);
  CHECK(estimate.status == Status::searching);
}

TEST_CASE("two places with as much evidence are ambiguous, however much that is") {
  for (const double nat : {3.0, 20.0, 500.0}) {
    Answer answer;
    PoseEstimate estimate;
    for (int k = 0; k < 10; ++k) estimate = answer.to({hypothesis(1, kHere, nat), hypothesis(2, kThere, nat)});
    CHECK(estimate.status == Status::ambiguous);
    REQUIRE(estimate.alternatives.size() == 1);
    CHECK(estimate.alternatives[0].hypothesis == HypothesisId(2));
    CHECK(estimate.alternatives[0].probability == Approx(estimate.probability));
    CHECK(distance_m(estimate.alternatives[0].T_map_base, kThere) == Approx(0).margin(1e-9));
  }
}

TEST_CASE("hypotheses at one place are one place and add up") {
  Answer answer;
  PoseEstimate estimate;
  for (int k = 0; k < 10; ++k)
    estimate = answer.to({hypothesis(1, kHere, 20), hypothesis(2, kHere * Pose2(0.5, 0, 0.1), 20)});
  CHECK(estimate.alternatives.empty());
  CHECK(estimate.status == Status::localized);
}

TEST_CASE("the same position with another heading is another place") {
  Answer answer;
  CHECK(answer.to({hypothesis(1, kHere, 9), hypothesis(2, kHere * Pose2(0, 0, 0.5), 9)}).alternatives.size() == 1);
}

TEST_CASE("a place is localized once its probability has held for the weight that is asked for, and not before") {
  const double weight = GENERATE(1.0, 0.5, 0.125);
  CAPTURE(weight);
  CHECK(Answer().weight_until_localized({weight, 0, 0}) == Approx(StatusOptions{}.localized_weight));
}

TEST_CASE("a place that changes has to hold anew") {
  Answer answer;
  for (int k = 0; k < 10; ++k) {
    const Pose2 at = k % 2 ? kHere : kThere;
    CHECK(answer.to({hypothesis(k, at, 20)}).status != Status::localized);
    CHECK(answer.to({hypothesis(k, at, 20)}).status != Status::localized);
  }
}

TEST_CASE("a probability that drops in between has to hold anew") {
  Answer answer;
  const std::vector<Live> sure{hypothesis(1, kHere, 20)}, unsure{hypothesis(1, kHere, 20), hypothesis(2, kThere, 19)};
  for (int k = 0; k < 5; ++k) {
    CHECK(answer.to(unsure).status == Status::ambiguous);
    CHECK_FALSE(answer.estimator.believed());
    CHECK(answer.to(sure).status == Status::searching);
    CHECK(answer.estimator.believed());
  }
}

TEST_CASE("the more walls are not on the map, the longer a place has to hold, up to the most") {
  const StatusOptions options;
  const auto asked = [](double unmapped_m) { return Answer().weight_until_localized({1, 0, unmapped_m}); };
  CHECK(asked(0) == options.localized_weight);
  CHECK(asked(options.localized_unmapped_m) == options.localized_weight);
  CHECK(asked(options.localized_unmapped_m + 4) == options.localized_weight + 4 * options.localized_weight_per_m);
  CHECK(asked(1000) == options.localized_most_weight);
}

TEST_CASE("the less a map agrees with what is seen, the longer a place has to hold, up to the most") {
  const StatusOptions options;
  const auto asked = [](double met, double passed) {
    Circumstances now;
    now.agreement = {met, passed};
    return Answer().weight_until_localized(now);
  };
  CHECK(asked(0.5, 0.2) == options.localized_weight);
  CHECK(asked(0.2, 0.2) == options.localized_weight);
  CHECK(asked(0, 0) == options.localized_weight);  // nothing mapped is in view: others say what that means
  const double missing = options.localized_agreement - 0.4;
  CHECK(asked(0.2, 0.3) ==
        Approx(options.localized_weight + options.localized_weight_per_share * missing).margin(1.01));
  StatusOptions strict;
  strict.localized_weight_per_share = 1000;
  Circumstances none;
  none.agreement = {0.2, 0.3};
  CHECK(Answer(strict).weight_until_localized(none) == strict.localized_most_weight);
}

TEST_CASE("a map through which most beams pass is another building's, however long a place holds") {
  const StatusOptions options;
  Circumstances now;
  now.agreement = {options.localized_least_agreement - 0.05, 1.05 - options.localized_least_agreement};
  Answer answer;
  CHECK(answer.weight_until_localized(now) >= 999);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("is it the map of this building?"));
  now.agreement = {options.localized_least_agreement + 0.05, 0.95 - options.localized_least_agreement};
  CHECK(Answer().weight_until_localized(now) <= options.localized_most_weight + 1);
}

TEST_CASE(
    "a place of which new evidence says nothing is not localized, however probable it is, until new evidence does") {
  Answer answer;
  for (int k = 0; k < 100; ++k) REQUIRE(answer.to({hypothesis(1, kHere, 20, -0.1)}).status != Status::localized);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("say nothing for it: -9.9 nat, not above 0"));
  for (int k = 0; k < 11; ++k) answer.to({hypothesis(1, kHere, 20, 1)});
  CHECK(answer.estimator.localized());
}

TEST_CASE("missing walls never ask for less than is always asked for") {
  StatusOptions options;
  options.localized_weight = 30;  // more than the most for missing walls
  CHECK(Answer(options).weight_until_localized({1, 0, 1000}) == 30);
}

TEST_CASE("a scan that says nothing wears down what hypotheses do not keep up with") {
  Answer answer;
  double before = 0;
  for (int k = 0; k < 50; ++k) {
    const PoseEstimate estimate = answer.to({hypothesis(1, kHere, 4)});
    CHECK(estimate.none > before);
    before = estimate.none;
  }
}

TEST_CASE("probabilities of hypotheses and of none of them sum to one, those of places to one at most") {
  const unsigned seed = GENERATE(1u, 2u, 3u);
  CAPTURE(seed);
  std::mt19937 bits(seed);
  std::uniform_real_distribution<double> nat(-5, 12), at_m(-3, 3), share(0, 1);
  Answer answer;
  for (int k = 0; k < 50; ++k) {
    std::vector<Live> alive;
    for (int n = static_cast<int>(bits() % 12); n > 0; --n)
      alive.emplace_back(hypothesis(n, {at_m(bits), at_m(bits), at_m(bits)}, 0)).hypothesis.log_likelihood = nat(bits);
    std::sort(alive.begin(), alive.end(),
              [](const Live& a, const Live& b) { return a.hypothesis.log_likelihood > b.hypothesis.log_likelihood; });
    const PoseEstimate estimate = answer.to(alive, {1, share(bits) * 0.5, 0});
    CHECK(sum_of(answer.estimator.belief().hypotheses) + answer.estimator.belief().none == Approx(1));
    CHECK(total(estimate) <= 1 + 1e-9);
    CHECK(estimate.none == answer.estimator.belief().none);
  }
}

TEST_CASE("evidence of any size gives probabilities") {
  for (const double nat : {-1e6, 0.0, 1e6}) {
    Answer answer;
    const PoseEstimate estimate = answer.to({hypothesis(1, kHere, nat), hypothesis(2, kThere, nat - 1)});
    CHECK((std::isfinite(estimate.probability) && estimate.probability >= 0));
    CHECK(total(estimate) <= 1 + 1e-9);
  }
}

TEST_CASE("an estimate between two scans is carried by odometry") {
  const Pose2 T_local_base(1, 1, 0.3), driven(0.8, 0.1, 0.2);
  StatusEstimator estimator({}, kDecisionMemory);
  estimator.estimate({hypothesis(1, kHere, 20, 1, T_local_base)}, T_local_base, 5, {});
  const PoseEstimate later = estimator.at(6, T_local_base * driven);
  CHECK(later.stamp_s == 6);
  CHECK(distance_m(later.T_map_base, kHere * driven) == Approx(0).margin(1e-9));
  CHECK(angle_between_rad(later.T_map_base, kHere * driven) == Approx(0).margin(1e-9));
  CHECK(distance_m(estimator.at(5, T_local_base).T_map_base, kHere) == Approx(0).margin(1e-9));
}

// It is carried along the best hypothesis' heading instead.
TEST_CASE("an alternative between two scans drives where it says the robot looks") {
  const Pose2 driven(1, 0, 0.2);
  StatusEstimator estimator({}, kDecisionMemory);
  estimator.estimate({hypothesis(1, kHere, 9), hypothesis(2, kThere, 9)}, Pose2(), 5, {});
  const PoseEstimate later = estimator.at(6, driven);
  REQUIRE(later.alternatives.size() == 1);
  CHECK(distance_m(later.alternatives[0].T_map_base, kThere * driven) == Approx(0).margin(1e-9));
}

// They stand in the order in which a hypothesis first named them.
TEST_CASE("alternatives stand in order of their probability") {
  Answer answer;
  const PoseEstimate estimate =
      answer.to({hypothesis(1, kHere, 9), hypothesis(2, kThere, 8.5), hypothesis(3, kElsewhere, 8.4),
                 hypothesis(4, kElsewhere * Pose2(0.4, 0, 0), 8.4)});
  REQUIRE(estimate.alternatives.size() == 2);
  CHECK(estimate.alternatives[0].probability >= estimate.alternatives[1].probability);
}

TEST_CASE("a robot without a pose has none between two scans either") {
  Answer answer;
  answer.to({});
  CHECK_FALSE(answer.estimator.at(7, Pose2(1, 0, 0)).has_pose);
}

TEST_CASE("what is taken off hypotheses and off none of them alike changes no belief") {
  constexpr Circumstances kNothingNew{1e-9, 0, 0};
  Answer answer;
  for (int k = 0; k < 20; ++k) answer.to({hypothesis(1, kHere, 4)});
  const double before = answer.estimator.belief().none;
  answer.estimator.settle(1, -100);
  CHECK(answer.to({hypothesis(1, kHere, 3)}, kNothingNew).none == Approx(before).margin(1e-6));
}

TEST_CASE("settling leaves none of them what it is told to leave") {
  constexpr Circumstances kNothingNew{1e-9, 0, 0};
  Answer answer;
  answer.to({});
  answer.estimator.settle(1000, -2);
  const double none = answer.to({hypothesis(1, kHere, 0)}, kNothingNew).none;
  CHECK(none == Approx(std::exp(-2) / (1 + std::exp(-2))).margin(1e-6));
}

TEST_CASE("an estimator that is reset has forgotten what was") {
  Answer answer = localized_here();
  answer.estimator.reset();
  CHECK_FALSE(answer.estimator.localized());
  CHECK_FALSE(answer.estimator.believed());
  CHECK(answer.estimator.probability() == 0);
  const PoseEstimate anew = answer.to({hypothesis(1, kHere, 3)});
  CHECK(anew.status != Status::localized);
  CHECK(anew.none == Answer().to({hypothesis(1, kHere, 3)}).none);
}

TEST_CASE("a place has to lead over every other place by a share of its evidence") {
  const auto after = [](double here_nat, double there_nat, const StatusOptions& options) {
    Answer answer(options);
    PoseEstimate estimate;
    for (int k = 0; k < 30; ++k)
      estimate = answer.to({hypothesis(1, kHere, here_nat), hypothesis(2, kThere, there_nat)});
    return std::pair(estimate, answer.estimator.belief().why);
  };
  const auto [close, why] = after(60, 55, {});
  CHECK(close.probability > 0.99);
  CHECK(close.status == Status::ambiguous);
  REQUIRE(close.alternatives.size() == 1);
  CHECK(distance_m(close.alternatives.front().T_map_base, kThere) < 1e-9);
  CHECK(why ==
        "another place explains what was seen nearly as well: its evidence is 5.0 nat less of 60.0, and should "
        "be 9.0 less");
  CHECK(after(60, 50.9, {}).first.status == Status::localized);
  CHECK(after(20, 15, {}).first.status == Status::localized);
  const double most_nat = StatusOptions{}.localized_lead_nat;
  CHECK(after(200, 200 - most_nat - 0.1, {}).first.status == Status::localized);
  CHECK(after(200, 200 - most_nat + 0.1, {}).first.status == Status::ambiguous);
  StatusOptions none;
  none.localized_lead = 0;
  CHECK(after(60, 55, none).first.status == Status::localized);
}

TEST_CASE("evidence from before a ride is no evidence between storeys") {
  Live here = hypothesis(1, kHere, 60), there = hypothesis(2, kThere, 55);
  here.ridden_nat = there.ridden_nat = 40;
  Answer answer;
  PoseEstimate estimate;
  for (int k = 0; k < 30; ++k) estimate = answer.to({here, there});
  CHECK(estimate.status == Status::localized);
}

TEST_CASE("a hypothesis at the same place is no other place, however near its evidence is") {
  Answer answer;
  PoseEstimate estimate;
  for (int k = 0; k < 30; ++k)
    estimate = answer.to({hypothesis(1, kHere, 60), hypothesis(2, kHere * Pose2(0.1, 0, 0), 59)});
  CHECK(estimate.status == Status::localized);
}
