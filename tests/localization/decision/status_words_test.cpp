#include "localization/decision/status.hpp"

#include <catch2/catch.hpp>

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
