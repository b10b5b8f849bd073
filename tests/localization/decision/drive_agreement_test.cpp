#include "tests/localization/decision/made_status.hpp"

namespace opal {
namespace {

StatusOptions strict() {
  StatusOptions options;
  options.localized_drive_agreement = 0.8;
  return options;
}

Circumstances seen(double met, double passed) {
  Circumstances now;
  now.agreement = {met, passed};
  return now;
}

/// Half of the beams pass, and each scan fits another place best.
Answer after_a_poor_drive(const StatusOptions& options) {
  Answer answer(options);
  for (int k = 0; k < 40; ++k) answer.to({hypothesis(k, k % 2 == 0 ? kThere : kElsewhere, 20)}, seen(0.4, 0.4));
  return answer;
}

TEST_CASE("a map that did not explain the drive is not believed where it explains a part, if that is asked for") {
  const Circumstances sound = seen(0.8, 0);
  CHECK(after_a_poor_drive({}).weight_until_localized(sound) == StatusOptions().localized_weight);
  CHECK(Answer(strict()).weight_until_localized(sound) == StatusOptions().localized_weight);
  const double asked = after_a_poor_drive(strict()).weight_until_localized(sound);
  CHECK(asked > 8);
  CHECK(asked < 25);
}

TEST_CASE("what a map explains of the drive is told in shares of beams") {
  Answer answer = after_a_poor_drive(strict());
  for (int k = 0; k < 3; ++k) answer.to({hypothesis(1, kHere, 20)}, seen(0.6, 0));
  CHECK_THAT(answer.estimator.belief().why, Catch::StartsWith("on the last metres "));
  CHECK_THAT(
      answer.estimator.belief().why,
      Catch::EndsWith("and at most 20 % may, wherever the best place was: does the map show the building as it is?"));
}

TEST_CASE("what is seen under a wrong sensor description says nothing of the map") {
  Answer answer(strict());
  answer.estimator.contradict("the laser is turned");
  for (int k = 0; k < 40; ++k) answer.to({hypothesis(1, kHere, 20)}, seen(0, 0.8));
  answer.estimator.contradict("");
  CHECK(answer.weight_until_localized(seen(0.8, 0)) < 4);
}

}  // namespace
}  // namespace opal
