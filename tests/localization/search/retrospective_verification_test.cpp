#include "localization/search/retrospective_verification.hpp"

#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace opal;
using namespace opal::synthetic;

namespace {

constexpr double kMemory = 0.99;

VerificationOptions verification_options(int scans = 40) {
  VerificationOptions chosen;
  chosen.scans = scans;
  return chosen;
}

/// A robot that drives through the room from its left to its right, and remembers.
struct Past {
  explicit Past(std::vector<ActiveScorer> scorers = {{"fit", fit_scorer(), ScorerRole::decides, 1}},
                const VerificationOptions& given = verification_options(), double memory = kMemory)
      : judges(map, std::move(scorers)), past(map, judges.ensemble, given, memory) {}
  void see(double tempering_weight = 1, double best_nat = 2.9) {
    robot.drive_to(robot.T_map_base() * Pose2(0.4, 0.05, 0.02));
    keyframe = keyframe.next();
    past.remember(robot.observation(), keyframe, tempering_weight, best_nat);
  }
  void see_scans(int scans, double tempering_weight = 1) {
    for (int k = 0; k < scans; ++k) see(tempering_weight);
  }
  RetrospectiveVerification::Verdict truth() const { return past.verify(robot.truth(), robot.local_map()); }
  RetrospectiveVerification::Verdict elsewhere(const Pose2& T_map_base) const {
    return past.verify(robot.at(T_map_base), robot.local_map());
  }
  /// The room looks alike from there but for its column.
  RetrospectiveVerification::Verdict turned_about() const {
    return elsewhere(Pose2(10, 7, std::numbers::pi) * robot.T_map_base());
  }

  std::shared_ptr<const MapView> map = view_of(room());
  Judges judges;
  RetrospectiveVerification past;
  Robot robot{map, Pose2(2, 4, 0)};
  KeyframeId keyframe{0};
};

/// Each scan says this for every hypothesis.
Past past_of(double nat, const VerificationOptions& given = verification_options(), double memory = kMemory) {
  return Past({{"constant", constant_scorer(nat), ScorerRole::decides, 1}}, given, memory);
}

}  // namespace

TEST_CASE("where nothing was seen, nothing speaks for or against a candidate") {
  const auto verdict = Past().truth();
  CHECK(verdict.nat == 0);
  CHECK(verdict.scans == 0);
  CHECK_FALSE(verdict.hopeless);
}

TEST_CASE("a scan is kept for every whole piece of evidence, and the first one at once") {
  Past past;
  past.see(0.25);
  CHECK(past.truth().scans == 1);
  past.see_scans(3, 0.25);
  CHECK(past.truth().scans == 1);
  past.see(0.25);
  CHECK(past.truth().scans == 2);
  past.see_scans(16, 0.25);
  CHECK(past.truth().scans == 6);
}

TEST_CASE("no more scans are kept than asked for, the newest ones") {
  Past past({{"fit", fit_scorer(), ScorerRole::decides, 1}}, verification_options(3));
  past.see_scans(10);
  CHECK(past.truth().scans == 3);
  past.past.forget_until(KeyframeId(7));
  CHECK(past.truth().scans == 3);  // 8, 9 and 10
  past.past.forget_until(KeyframeId(9));
  CHECK(past.truth().scans == 1);
}

TEST_CASE("who may keep no scan verifies nothing") {
  Past past({{"fit", fit_scorer(), ScorerRole::decides, 1}}, verification_options(0));
  past.see_scans(10);
  CHECK(past.truth().scans == 0);
  CHECK(past.past.since_newest(0.3) == 1);
}

TEST_CASE("a scan without points is not kept") {
  Past past;
  past.robot.drive_blind_to(Pose2(3, 4, 0));
  past.past.remember(past.robot.observation(), KeyframeId(1), 1, 0);
  CHECK(past.truth().scans == 0);
}

TEST_CASE("how new a scan is grows with what came since the newest that is kept, up to a whole") {
  Past past;
  CHECK(past.past.since_newest(0.3) == 1);  // there is none
  past.see(1);
  CHECK(past.past.since_newest(0.3) == Approx(0.3));
  past.see(0.25);
  CHECK(past.past.since_newest(0.3) == Approx(0.55));
  past.see(0.5);
  CHECK(past.past.since_newest(0.3) == 1);
}

TEST_CASE("the true pose has more behind it than a wrong one") {
  Past past;
  past.see_scans(8);
  const auto truth = past.truth();
  CHECK(truth.scans == 8);
  CHECK_FALSE(truth.hopeless);
  CHECK(truth.nat > 8 * 2.5);
  CHECK(truth.nat > past.turned_about().nat + 1);
  CHECK(truth.nat > past.elsewhere(Pose2(2, 2, 1)).nat + 1);
}

TEST_CASE("a wrong pose is told to be hopeless before all scans are looked at") {
  Past past;
  past.see_scans(12);
  const auto verdict = past.elsewhere(Pose2(2, 2, 0.8));
  CHECK(verdict.hopeless);
  CHECK(verdict.scans < 12);
}

TEST_CASE("who is within the lead that the status asks for is not hopeless, however much evidence there is") {
  const auto verdict = [](const AskedLead& lead) {
    const std::shared_ptr<const MapView> map = view_of(room());
    Judges judges(map, {{"constant", constant_scorer(9), ScorerRole::decides, 1}});
    RetrospectiveVerification past(map, judges.ensemble, verification_options(), 1, lead);
    Robot robot(map, Pose2(2, 4, 0));
    for (int k = 0; k < 10; ++k) past.remember(robot.observation(), KeyframeId(k), 1, 10);
    return past.verify(robot.truth(), robot.local_map());
  };
  CHECK(verdict({}).hopeless);  // 10 nat less of 100
  CHECK(verdict({.share = 0.05}).hopeless);
  CHECK_FALSE(verdict({.share = 0.2}).hopeless);
  CHECK(verdict({.share = 0.2, .most_nat = 9}).hopeless);
}

TEST_CASE("who keeps up with the best of the time is not hopeless, however little that was") {
  Past past = past_of(-3);
  for (int k = 0; k < 14; ++k) past.see(1, -3);
  const auto verdict = past.truth();
  CHECK_FALSE(verdict.hopeless);
  CHECK(verdict.scans == 14);
}

TEST_CASE("evidence of old scans counts as much less as tracking has forgotten of it") {
  const double memory = 0.5;
  Past past = past_of(1, verification_options(), memory);
  past.see_scans(3);
  CHECK(past.truth().nat == Approx(memory + memory * memory + memory * memory * memory));
}

TEST_CASE("a candidate meets the scans before as something new: what it saw of them it remembers") {
  Past past({{"count", std::make_shared<CountingScorer>(), ScorerRole::decides, 1}});
  past.see_scans(4);
  const auto verdict = past.truth();
  Hypothesis hypothesis;
  hypothesis.memories = verdict.memories;
  CHECK(count_of(hypothesis, 0) == 4);
}

TEST_CASE("verifying a hypothesis leaves its own memories alone") {
  Past past({{"count", std::make_shared<CountingScorer>(), ScorerRole::decides, 1}});
  past.see_scans(4);
  Hypothesis hypothesis = past.robot.truth();
  past.judges.ensemble.remember(hypothesis, past.judges.ensemble.judge(hypothesis, past.robot.observation()).scores, 1);
  past.past.verify(hypothesis, past.robot.local_map());
  CHECK(count_of(hypothesis, 0) == 1);
}

TEST_CASE("what was seen before a kidnapping says nothing once it is forgotten") {
  Past past;
  past.see_scans(6);
  past.past.forget_until(KeyframeId(4));
  CHECK(past.truth().scans == 2);
  past.past.forget_until(KeyframeId(100));
  CHECK(past.truth().scans == 0);
}

TEST_CASE("a past that is cleared is none, whatever was suspected") {
  Past past;
  past.see_scans(6, 0.5);
  past.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(3), 50});
  past.past.clear();
  CHECK(past.truth().scans == 0);
  CHECK_FALSE(past.truth().kidnapped_after.exists());
  past.see(0.1);
  CHECK(past.truth().scans == 1);
}

TEST_CASE("a candidate that the past speaks for does not pay for a kidnapping") {
  Past past;
  past.see_scans(8);
  const double alone = past.truth().nat;
  past.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(5), -20});
  const auto verdict = past.truth();
  CHECK_FALSE(verdict.kidnapped_after.exists());
  CHECK(verdict.inherited_nat == 0);
  CHECK(verdict.nat == alone);
}

TEST_CASE("a candidate after a kidnapping has the scans since then and what it takes over, the price included") {
  const double memory = 1, takeover_nat = 6;
  Past past = past_of(1, verification_options(), memory);
  past.see_scans(8);
  past.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(5), takeover_nat});
  const auto verdict = past.truth();
  CHECK(verdict.kidnapped_after == KeyframeId(5));
  CHECK(verdict.inherited_nat == takeover_nat);
  CHECK(verdict.scans == 3);  // 6, 7 and 8
  CHECK(verdict.nat == Approx(3 + takeover_nat));
}

TEST_CASE("where the robot was kidnapped to is not hopeless because of what was seen before") {
  Past past;
  past.see_scans(8);
  past.robot = Robot(past.map, Pose2(8, 1, 2));  // a local map of its own, as far as this test sees
  const auto before = past.truth();
  CHECK(before.hopeless);
  past.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(8), 3});
  const auto verdict = past.truth();
  CHECK_FALSE(verdict.hopeless);
  CHECK(verdict.kidnapped_after == KeyframeId(8));
  CHECK(verdict.nat == 3);
  past.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(8), -100});  // a high price is a price all the same
  CHECK_FALSE(past.truth().hopeless);
  CHECK(past.truth().nat == -100);
}

TEST_CASE("a kidnapping excuses nothing that was seen since then") {
  Past past;
  past.see_scans(12);
  past.past.suspect(RetrospectiveVerification::Takeover{KeyframeId(1), 3});
  const auto verdict = past.elsewhere(Pose2(2, 2, 0.8));
  CHECK(verdict.hopeless);
  CHECK_FALSE(verdict.kidnapped_after.exists());
}

TEST_CASE("in retrospect no scan is more than one whole piece of evidence to a scorer") {
  Past past({{"count", std::make_shared<CountingScorer>(), ScorerRole::decides, 1}});
  past.see(0.6);
  past.see_scans(2, 0.6);
  Hypothesis hypothesis;
  hypothesis.memories = past.truth().memories;
  CHECK(count_of(hypothesis, 0) <= 0.6 + 1);
}

TEST_CASE("the first scan after a blind drive counts once") {
  Past past = past_of(1, verification_options(), 1);
  for (int k = 1; k <= 10; ++k) {
    past.robot.drive_blind_to(Pose2(2 + 0.4 * k, 4, 0));
    past.keyframe = past.keyframe.next();
    past.past.remember(past.robot.observation(), past.keyframe, 1, 0);
  }
  past.see(1);
  CHECK(past.truth().scans == 1);
  CHECK(past.truth().nat <= 2);
}

TEST_CASE("a scan that is a part of a piece of evidence counts as a part, for a candidate and against it") {
  Past part = past_of(2), against = past_of(-10), whole_against = past_of(-10);
  part.see(0.25);
  against.see(0.25);
  whole_against.see(1);
  CHECK(part.truth().nat == Approx(std::pow(kMemory, 0.25) * 0.25 * 2));
  CHECK_FALSE(against.truth().hopeless);  // 12.9 nat behind, by a quarter
  CHECK(whole_against.truth().hopeless);
}
