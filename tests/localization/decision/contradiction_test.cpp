// What the drive says against the sensor description decides over the status.
#include "tests/localization/decision/made_status.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace opal;

namespace {

/// One place that explains everything, for as many scans.
PoseEstimate sure_of_one_place(StatusEstimator& estimator, int scans) {
  PoseEstimate estimate;
  for (int k = 0; k < scans; ++k) estimate = estimator.estimate({hypothesis(1, kHere, 50)}, Pose2(), k, {});
  return estimate;
}

}  // namespace

TEST_CASE("while the sensor description is contradicted nothing is called localized, nor is it evidence for later") {
  StatusEstimator estimator({}, 0.99);
  estimator.contradict("scans move backwards");
  CHECK(sure_of_one_place(estimator, 20).status == Status::searching);
  CHECK(estimator.belief().why == "scans move backwards");
  estimator.contradict("");
  CHECK(sure_of_one_place(estimator, 1).status != Status::localized);
  CHECK(sure_of_one_place(estimator, 20).status == Status::localized);
}

TEST_CASE("a robot that is localized is lost once the sensor description is contradicted, between scans, too") {
  StatusEstimator estimator({}, 0.99);
  REQUIRE(sure_of_one_place(estimator, 20).status == Status::localized);
  estimator.contradict("scans move backwards");
  CHECK(estimator.at(100, Pose2()).status == Status::lost);
  CHECK(sure_of_one_place(estimator, 1).status == Status::lost);
}

TEST_CASE("evidence outlasts odometry that has frozen, and new evidence as of a new place has to confirm it") {
  const StatusOptions options;
  StatusEstimator estimator(options, 0.99);
  REQUIRE(sure_of_one_place(estimator, 20).status == Status::localized);
  estimator.suspend("odometry stands still");
  CHECK(sure_of_one_place(estimator, 5).status == Status::lost);
  CHECK(estimator.belief().why == "odometry stands still");
  estimator.suspend("");
  const int pieces = static_cast<int>(std::ceil(options.localized_weight));
  CHECK(sure_of_one_place(estimator, pieces - 1).status != Status::localized);
  CHECK_THAT(estimator.belief().why, Catch::Contains("the odometry broke off"));
  CHECK(sure_of_one_place(estimator, 1).status == Status::localized);
}
