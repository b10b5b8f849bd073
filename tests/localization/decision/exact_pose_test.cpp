// How well the pose is known decides over the status, where the place is.
#include "tests/localization/decision/made_status.hpp"

#include <catch2/catch.hpp>

using namespace opal;

TEST_CASE("a place that is known is not localized while the pose is not, and the reason says how well it is known") {
  const auto [drift, word] = GENERATE(table<Eigen::Vector3d, std::string>(
      {{Eigen::Vector3d(1, 0, 0), "within 2.9"}, {Eigen::Vector3d(0, 0, 0.1), "degrees"}}));
  Answer answer = localized_here();
  Live lost_along = hypothesis(1, kHere, 20);
  lost_along.pose.update({kHere, kHere, Eigen::Matrix3d(Eigen::Vector3d(4 * drift).asDiagonal())}, {kHere}, 0.05, {});
  CHECK(answer.to({lost_along}).status == Status::searching);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("the place is known") && Catch::Contains(word));
  CHECK(answer.to({hypothesis(1, kHere, 20)}).status == Status::localized);
}

TEST_CASE("how exact a localized pose has to be is asked for") {
  StatusOptions strict;
  strict.localized_within_m = 0.05;
  Answer answer(strict);
  for (int k = 0; k < 10; ++k) CHECK(answer.to({hypothesis(1, kHere, 20)}).status != Status::localized);
  CHECK_THAT(answer.estimator.belief().why, Catch::Contains("should be within 0.05 m"));
}
