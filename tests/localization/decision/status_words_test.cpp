#include "tests/localization/decision/made_status.hpp"

#include <fmt/format.h>

using namespace opal;

namespace {

Live lone_hypothesis(double nat) {
  Live live;
  live.hypothesis.id = HypothesisId(1);
  live.hypothesis.log_likelihood = nat;
  live.scan_nat = 1;
  return live;
}

}  // namespace

TEST_CASE("a probability that is just not enough does not look as if it were") {
  bool is_just_below = false;
  for (double nat = 1; nat < 20 && !is_just_below; nat += 0.005) {
    StatusEstimator estimator(StatusOptions{}, 0.99);
    estimator.estimate({lone_hypothesis(nat)}, Pose2(), 1, {});
    const double probability = estimator.estimate({lone_hypothesis(nat)}, Pose2(), 2, {}).probability;
    is_just_below = probability > 0.9896 && probability < 0.99;
    if (is_just_below) CHECK(estimator.belief().why == "the probability is 0.989, not above 0.990");
  }
  CHECK(is_just_below);
}

TEST_CASE("what a place still has to hold for is told with how much has held, and with what asks for more") {
  Answer answer;
  Circumstances now;
  now.tempering_weight = 0.5;
  const auto why_after = [&](int scans) {
    for (int k = 0; k < scans; ++k) answer.to({hypothesis(1, kHere, 20)}, now);
    return answer.estimator.belief().why;
  };
  why_after(1);  // the place is new
  CHECK(why_after(3) == "the probability that is asked for has held here for 1.50 of 2.00 pieces of new evidence");
  now.unmapped_walls_m = StatusOptions{}.localized_unmapped_m + 2;
  now.agreement = {0.6, 0.2};
  CHECK(
      why_after(1) ==
      "the probability that is asked for has held here for 2.00 of 4.00 pieces of new evidence, so many because 8.0 m "
      "of straight walls that were seen are not on the map");
}

TEST_CASE("a map that explains little is told with the share of beams that pass through what it has") {
  Circumstances now;
  now.agreement = {0.32, 0.48};
  Answer doubtful, both, elsewhere;
  for (int k = 0; k < 2; ++k) doubtful.to({hypothesis(1, kHere, 20)}, now);
  CHECK_THAT(doubtful.estimator.belief().why,
             Catch::EndsWith(", so many because 60 % of the beams that the map speaks about pass through what it has"));
  now.unmapped_walls_m = 20;
  for (int k = 0; k < 2; ++k) both.to({hypothesis(1, kHere, 20)}, now);
  CHECK_THAT(
      both.estimator.belief().why,
      Catch::Contains(", so many because 20.0 m of straight walls that were seen are not on the map, and 60 % of"));
  now.agreement = {0.16, 0.64};
  for (int k = 0; k < 2; ++k) elsewhere.to({hypothesis(1, kHere, 20)}, now);
  CHECK(elsewhere.estimator.belief().why ==
        "80 % of the beams that the map speaks about pass through what it has: is it the map of this building?");
}

TEST_CASE("a lost robot is told by how much its scans fit too badly, or how long ago one broke off") {
  Answer lost = localized_here(), broken = localized_here();
  for (int k = 0; k < 50; ++k) lost.to({hypothesis(1, kHere, 20, -2)});
  CHECK(lost.estimator.belief().why ==
        fmt::format("the newest scans score -2.00 nat on average, below {:.2f}", StatusOptions{}.lost_scan_nat));
  Circumstances now;
  now.is_broken = true;
  broken.to({hypothesis(1, kHere, 20)}, now);
  now = {};
  now.tempering_weight = 0.75;
  broken.to({hypothesis(1, kHere, 20)}, now);
  CHECK_THAT(
      broken.estimator.belief().why,
      Catch::StartsWith(fmt::format("0.75 of {:.2f} pieces of new evidence ago the scans or the odometry broke off",
                                    StatusOptions{}.localized_weight)));
}
