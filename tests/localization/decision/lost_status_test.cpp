#include "tests/localization/decision/made_status.hpp"

using namespace opal;

TEST_CASE("a robot that was localized is lost when scans fit no more, and not by one of them") {
  Answer answer = localized_here();
  CHECK(answer.to({hypothesis(1, kHere, 20, -1)}).status == Status::localized);
  PoseEstimate estimate;
  for (int k = 0; k < 10; ++k) estimate = answer.to({hypothesis(1, kHere, 20, -1)});
  CHECK(estimate.status == Status::lost);
  for (int k = 0; k < 10; ++k) estimate = answer.to({hypothesis(1, kHere, 20, 1)});
  CHECK(estimate.status == Status::localized);
}

TEST_CASE("who was never localized cannot be lost") {
  Answer answer;
  for (int k = 0; k < 20; ++k) {
    CHECK(answer.to({hypothesis(1, kHere, 3, -5)}).status != Status::lost);
    CHECK(answer.to({}).status == Status::searching);
  }
}

TEST_CASE("a robot that was localized is lost when no hypothesis is left, until it is reset") {
  Answer answer = localized_here();
  CHECK(answer.to({}).status == Status::lost);
  answer.estimator.reset();
  CHECK(answer.to({}).status == Status::searching);
}

TEST_CASE("a kidnapping that is probable makes the robot lost, and its place improbable") {
  Answer answer = localized_here();
  const PoseEstimate estimate = answer.to({hypothesis(1, kHere, 20)}, {1, 0.6, 0});
  CHECK(estimate.status == Status::lost);
  CHECK(estimate.probability < 0.4 + 1e-9);
  CHECK(estimate.none >= 0.6);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("kidnapped with probability 0.600, not below 0.010"));
  CHECK(answer.to({hypothesis(1, kHere, 20)}).status == Status::localized);  // it was none
}

TEST_CASE("a place is not localized while a kidnapping from it is probable") {
  CHECK(Answer().weight_until_localized({1, 0.05, 0}) > 900);
}

TEST_CASE(
    "after a scan that breaks off from those before, a place has to hold anew, though nothing speaks against it") {
  Answer answer = localized_here();
  Circumstances broken;
  broken.is_broken = true;
  const PoseEstimate estimate = answer.to({hypothesis(1, kHere, 20)}, broken);
  CHECK(estimate.status == Status::searching);
  CHECK(estimate.probability > 0.99);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("the scans or the odometry broke off from those before"));
  CHECK(answer.estimator.believed());
  CHECK(answer.weight_until_localized({}) == Approx(StatusOptions{}.localized_weight).margin(1));
  answer.estimator.reset();
  CHECK(answer.weight_until_localized({}) == Answer().weight_until_localized({}));
}

TEST_CASE(
    "the newest scans count by a running mean: of many that fit a little too badly it takes as many as it should") {
  Answer answer = localized_here();  // by scans of 1 nat
  const double scan_nat = -0.5;      // the mean after k of them: 1.5 * 0.8^k - 0.5
  for (int k = 1; k <= 7; ++k) CHECK(answer.to({hypothesis(1, kHere, 20, scan_nat)}).status == Status::localized);
  CHECK(answer.to({hypothesis(1, kHere, 20, scan_nat)}).status == Status::lost);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("score -0.25 nat on average"));
}

TEST_CASE("where the best place has just changed, that is the reason, whatever scan broke off") {
  Answer answer;
  Circumstances broken;
  broken.is_broken = true;
  answer.to({hypothesis(1, kHere, 20)}, broken);
  CHECK(answer.to({hypothesis(2, kThere, 20)}, broken).status == Status::searching);
  CHECK(answer.estimator.belief().why == "the best place has just changed");
}

TEST_CASE("of two places that are as probable the probability is the reason, also when the best one has just changed") {
  Answer answer;
  answer.to({hypothesis(1, kHere, 20), hypothesis(2, kThere, 20)});
  CHECK_THAT(answer.estimator.belief().why, Catch::StartsWith("the probability is 0.499, not above 0.990"));
  answer.to({hypothesis(2, kThere, 20), hypothesis(1, kHere, 20)});
  CHECK_THAT(answer.estimator.belief().why, Catch::StartsWith("the probability is 0.499, not above 0.990"));
}

TEST_CASE("the probability that is the reason is the one that is told, which a probable kidnapping makes less") {
  Answer answer;
  Circumstances kidnapped;
  kidnapped.kidnapped = 0.9;
  const auto estimate = answer.to({hypothesis(1, kHere, 20), hypothesis(2, kThere, 16.5)}, kidnapped);
  CHECK(estimate.probability == Approx(0.097).margin(0.001));
  CHECK_THAT(answer.estimator.belief().why, Catch::StartsWith("the probability is 0.09"));
}

TEST_CASE("a break is remembered, whatever else speaks against the place at that scan") {
  Answer answer = localized_here();
  Circumstances broken;
  broken.is_broken = true;
  broken.kidnapped = 0.02;
  CHECK(answer.to({hypothesis(1, kHere, 20)}, broken).status == Status::lost);
  Circumstances soon;
  soon.tempering_weight = 0.1;
  CHECK(answer.to({hypothesis(1, kHere, 20)}, soon).status != Status::localized);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("the scans or the odometry broke off from those before"));
  CHECK(answer.weight_until_localized(soon) == Approx(StatusOptions{}.localized_weight).margin(0.3));
}
