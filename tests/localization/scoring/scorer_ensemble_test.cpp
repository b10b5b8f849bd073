#include "localization/scoring/scorer_ensemble.hpp"

#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <map>
#include <stdexcept>

using namespace opal;
using namespace opal::synthetic;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A hypothesis and an observation about which scorers may say what they are told to.
struct Moment {
  std::shared_ptr<const MapView> map = view_of(room());
  Robot robot{map, Pose2(6.5, 4, 0.4)};
  Observation seen = robot.observation();
  Hypothesis hypothesis = robot.truth();
};

ActiveScorer deciding(const std::string& name, double nat, double weight = 1, const std::string& veto = {}) {
  return {name, constant_scorer(nat, veto), ScorerRole::decides, weight};
}
ActiveScorer observing(const std::string& name, double nat, const std::string& veto = {}) {
  return {name, constant_scorer(nat, veto), ScorerRole::observes, 1};
}
ActiveScorer throwing(const std::string& name) {
  return {name, std::make_shared<ToldScorer>([](const Hypothesis&, const Observation&) -> Score {
            throw std::runtime_error("no idea");
          }),
          ScorerRole::decides, 1};
}
ActiveScorer counting(const std::string& name, double weight = 1) {
  return {name, std::make_shared<CountingScorer>(), ScorerRole::decides, weight};
}

}  // namespace

TEST_CASE("the deciding scorers' opinions add up by their weights, and those of observers do not") {
  const Moment moment;
  const Judges judges(moment.map, {deciding("a", 2, 0.5), observing("b", 100), deciding("c", -3, 2)});
  const auto verdict = judges.ensemble.judge(moment.hypothesis, moment.seen);
  CHECK(verdict.nat == Approx(-5));
  CHECK(judges.ensemble.decide(moment.hypothesis, moment.seen) == Approx(verdict.nat));
  REQUIRE(verdict.scores.size() == 3);
  CHECK(verdict.scores[0].log_likelihood == 2);  // before its weight
  CHECK(verdict.scores[1].log_likelihood == 100);
}

TEST_CASE("nobody's opinion is no evidence") {
  const Moment moment;
  const Judges judges(moment.map, {});
  CHECK(judges.ensemble.decide(moment.hypothesis, moment.seen) == 0);
  CHECK(judges.ensemble.judge(moment.hypothesis, moment.seen).veto.empty());
}

TEST_CASE("the first veto of a scorer that decides counts, with its name") {
  const Moment moment;
  const Judges judges(moment.map, {observing("onlooker", 0, "out of the map"), deciding("content", 1),
                                   deciding("strict", 1, 1, "through a wall"), deciding("late", 1, 1, "too late")});
  CHECK(judges.ensemble.judge(moment.hypothesis, moment.seen).veto == "strict: through a wall");
}

TEST_CASE("an observer's veto ends nothing") {
  const Moment moment;
  const Judges judges(moment.map, {observing("onlooker", 0, "out of the map"), deciding("content", 1)});
  CHECK(judges.ensemble.judge(moment.hypothesis, moment.seen).veto.empty());
}

TEST_CASE("a scorer that throws contributes nothing and is counted each time") {
  const Moment moment;
  const Judges judges(moment.map, {throwing("bad"), deciding("good", 2)});
  CHECK(judges.ensemble.decide(moment.hypothesis, moment.seen) == 2);
  const auto verdict = judges.ensemble.judge(moment.hypothesis, moment.seen);
  CHECK(verdict.nat == 2);
  CHECK(verdict.scores.size() == 2);  // the order stays
  CHECK(judges.failures.counts() == std::map<std::string, int>{{"bad", 2}});
}

TEST_CASE("a score that is no number contributes nothing, its veto neither, and is counted") {
  const Moment moment;
  for (const double nat : {kNan, kInfinity, -kInfinity}) {
    const Judges judges(moment.map, {deciding("bad", nat, 1, "whatever"), deciding("good", 2)});
    const auto verdict = judges.ensemble.judge(moment.hypothesis, moment.seen);
    CHECK(verdict.nat == 2);
    CHECK(verdict.veto.empty());
    CHECK(judges.failures.counts().at("bad") == 1);
  }
}

TEST_CASE("an observer that throws changes nothing for those that decide") {
  const Moment moment;
  ActiveScorer bad = throwing("bad");
  bad.role = ScorerRole::observes;
  const Judges judges(moment.map, {bad, deciding("good", 2)});
  CHECK(judges.ensemble.judge(moment.hypothesis, moment.seen).nat == 2);
}

TEST_CASE("each scorer sees its own memory") {
  const Moment moment;
  const Judges judges(moment.map, {counting("a"), deciding("forgetful", 0), counting("b", 10)});
  Hypothesis hypothesis = moment.hypothesis;
  const auto verdict = judges.ensemble.judge(hypothesis, moment.seen);
  judges.ensemble.remember(hypothesis, {verdict.scores[0], Score{}, Score{}}, 1);
  CHECK(judges.ensemble.decide(hypothesis, moment.seen) == 1);  // b has met nothing
  judges.ensemble.remember(hypothesis, {Score{}, Score{}, verdict.scores[2]}, 0.5);
  CHECK(count_of(hypothesis, 0) == 1);
  CHECK(count_of(hypothesis, 2) == 0.5);
  CHECK(judges.ensemble.decide(hypothesis, moment.seen) == 1 + 10 * 0.5);
}

// new_memory threw, so there is none, and the scorer is asked all the same.
TEST_CASE("a scorer that made no memory is never asked without one") {
  struct Forgetful : CountingScorer {
    std::unique_ptr<ScorerMemory> new_memory(const MapView&) const override {
      throw std::runtime_error("out of memory");
    }
    Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory* memory) const override {
      CHECK(memory != nullptr);
      return {};
    }
  };
  const Moment moment;
  const Judges judges(moment.map, {{"forgetful", std::make_shared<Forgetful>(), ScorerRole::decides, 1}});
  CHECK(judges.failures.counts().at("forgetful") == 1);
  judges.ensemble.decide(moment.hypothesis, moment.seen);
}

TEST_CASE("a hypothesis without memories is one that has met nothing yet, again and again") {
  const Moment moment;
  const Judges judges(moment.map, {counting("a")});
  Hypothesis first = moment.hypothesis, second = moment.hypothesis;
  judges.ensemble.remember(first, judges.ensemble.judge(first, moment.seen).scores, 1);
  CHECK(judges.ensemble.decide(first, moment.seen) == 1);
  CHECK(judges.ensemble.decide(second, moment.seen) == 0);
  judges.ensemble.fade(second, 1);
  CHECK(second.memories.empty());
}

TEST_CASE("hypotheses that branch share what they remember until one of them meets something") {
  const Moment moment;
  const Judges judges(moment.map, {counting("a"), counting("b")});
  Hypothesis parent = moment.hypothesis;
  const auto scores = judges.ensemble.judge(parent, moment.seen).scores;
  judges.ensemble.remember(parent, scores, 1);
  Hypothesis child = parent;
  CHECK(child.memories.of(0) == parent.memories.of(0));
  judges.ensemble.remember(child, {scores[0], Score{}}, 1);
  CHECK(count_of(child, 0) == 2);
  CHECK(count_of(parent, 0) == 1);
  CHECK(child.memories.of(1) == parent.memories.of(1));  // it did not change
}

TEST_CASE("what fades for one hypothesis does not fade for its sibling") {
  const Moment moment;
  const Judges judges(moment.map, {counting("a")});
  Hypothesis parent = moment.hypothesis;
  judges.ensemble.remember(parent, judges.ensemble.judge(parent, moment.seen).scores, 1);
  Hypothesis child = parent;
  judges.ensemble.fade(child, 1);
  CHECK(count_of(child, 0) == 0.5);
  CHECK(count_of(parent, 0) == 1);
}

TEST_CASE("judging changes no memory") {
  const Moment moment;
  const Judges judges(moment.map, {counting("a")});
  Hypothesis hypothesis = moment.hypothesis;
  judges.ensemble.remember(hypothesis, judges.ensemble.judge(hypothesis, moment.seen).scores, 1);
  for (int k = 0; k < 3; ++k) judges.ensemble.judge(hypothesis, moment.seen);
  CHECK(count_of(hypothesis, 0) == 1);
}

TEST_CASE("a memory of its own is null where the scorer remembers nothing") {
  ScorerMemories none, mixed({nullptr, std::make_shared<CountMemory>()});
  CHECK(none.empty());
  CHECK(none.own(0) == nullptr);
  CHECK(mixed.own(0) == nullptr);
  CHECK(mixed.own(1) != nullptr);
  CHECK(mixed.own(2) == nullptr);
  CHECK(mixed.of(2) == nullptr);
}

TEST_CASE("associations matter to the ensemble if they matter to any scorer") {
  const Moment moment;
  const ActiveScorer by_scan{"scan", fit_scorer(), ScorerRole::decides, 1};
  CHECK_FALSE(Judges(moment.map, {by_scan}).ensemble.judges_associations());
  CHECK(Judges(moment.map, {by_scan, deciding("a", 0)}).ensemble.judges_associations());
}

TEST_CASE("of many findings of a scorer the first three are told, whatever others find") {
  struct Talkative : HypothesisScorer {
    Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
      return {};
    }
    std::vector<Finding> explain(const Hypothesis&, const Observation&, const MapView&) const override {
      return {{"1", {}, {}}, {"2", {}, {}}, {"3", {}, {}}, {"4", {}, {}}};
    }
  };
  const Moment moment;
  const auto talkative = std::make_shared<Talkative>();
  const Judges judges(moment.map, {{"a", talkative}, {"b", talkative}});
  std::string told;
  for (const auto& [scorer, finding] : judges.ensemble.explain(moment.hypothesis, moment.seen))
    told += scorer + finding.words + " ";
  CHECK(told == "a1 a2 a3 b1 b2 b3 ");
}

TEST_CASE("a scorer that cannot explain itself leaves the others' findings") {
  struct Speaking : HypothesisScorer {
    explicit Speaking(bool fails) : fails_(fails) {}
    Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
      return {};
    }
    std::vector<Finding> explain(const Hypothesis&, const Observation&, const MapView&) const override {
      if (fails_) throw std::runtime_error("no words");
      return {{"it fits", {}, {}}};
    }
    bool fails_;
  };
  const Moment moment;
  const Judges judges(moment.map,
                      {{"dumb", std::make_shared<Speaking>(true)}, {"clear", std::make_shared<Speaking>(false)}});
  const auto findings = judges.ensemble.explain(moment.hypothesis, moment.seen);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].scorer == "clear");
  CHECK(judges.failures.counts().at("dumb") == 1);
}
