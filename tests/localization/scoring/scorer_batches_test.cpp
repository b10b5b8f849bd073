#include "localization/scoring/scorer_ensemble.hpp"

#include "tests/localization/synthetic_scene.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <stdexcept>

using namespace opal;
using namespace opal::synthetic;

namespace {

/// Says the id of each hypothesis, in one call; and how often it was called. It gives `surplus` scores too many.
class BatchOfIds final : public HypothesisScorer {
 public:
  explicit BatchOfIds(std::size_t surplus = 0, double first = 0) : surplus_(surplus), first_(first) {}

  Score score(const Hypothesis& hypothesis, const Observation&, const MapView&, const ScorerMemory*) const override {
    return {double(hypothesis.id.number()), {}, {}};
  }
  std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses,
                               std::span<const ScorerMemory* const> memories, const Observation& seen,
                               const MapView& map) const override {
    ++calls;
    CHECK(std::vector<const ScorerMemory*>(memories.begin(), memories.end()) ==
          std::vector<const ScorerMemory*>(hypotheses.size()));  // it remembers nothing
    std::vector<Score> scores = HypothesisScorer::score_all(hypotheses, memories, seen, map);
    if (first_ != 0) scores.front().log_likelihood = first_;
    scores.resize(scores.size() + surplus_);
    return scores;
  }

  mutable int calls = 0;

 private:
  std::size_t surplus_;
  double first_;
};

struct Number final : ScorerMemory {
  explicit Number(double number) : value(number) {}
  std::unique_ptr<ScorerMemory> copy() const override { return std::make_unique<Number>(*this); }
  double value;
};

/// Says what it remembers of each hypothesis, in one call. Every scan adds the id of the hypothesis.
class BatchOfMemories final : public HypothesisScorer {
 public:
  std::unique_ptr<ScorerMemory> new_memory(const MapView&) const override { return std::make_unique<Number>(10); }
  Score score(const Hypothesis& hypothesis, const Observation&, const MapView&,
              const ScorerMemory* memory) const override {
    const double value = static_cast<const Number&>(*memory).value;
    return {value, {}, {}, std::make_shared<Number>(hypothesis.id.number())};
  }
  std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses,
                               std::span<const ScorerMemory* const> memories, const Observation& seen,
                               const MapView& map) const override {
    ++calls;
    return HypothesisScorer::score_all(hypotheses, memories, seen, map);
  }
  void remember(ScorerMemory& memory, const ScorerMemory& seen, double weight) const override {
    static_cast<Number&>(memory).value += weight * static_cast<const Number&>(seen).value;
  }

  mutable int calls = 0;
};

/// Three hypotheses with the ids 0, 1 and 2, and an observation.
struct Three {
  Three() : all(3, robot.truth()) {
    for (int k = 0; k < 3; ++k) {
      all[std::size_t(k)].id = HypothesisId(k);
      pointers.push_back(&all[std::size_t(k)]);
    }
  }
  std::shared_ptr<const MapView> map = view_of(room());
  Robot robot{map, Pose2(6.5, 4, 0.4)};
  Observation seen = robot.observation();
  std::vector<Hypothesis> all;
  std::vector<const Hypothesis*> pointers;
};

ActiveScorer always(const std::string& name, double nat, double weight = 1, const std::string& veto = {}) {
  return {name, constant_scorer(nat, veto), ScorerRole::decides, weight};
}

}  // namespace

TEST_CASE("many hypotheses are judged as one after the other, and each scorer is asked once") {
  const Three three;
  const auto batch = std::make_shared<BatchOfIds>();
  const Judges judges(three.map, {always("a", 2, 0.5),
                                  {"ids", batch, ScorerRole::decides, 2},
                                  {"b", constant_scorer(100), ScorerRole::observes, 1},
                                  always("strict", 1, 1, "through a wall")});
  const auto verdicts = judges.ensemble.judge_all(three.pointers, three.seen);
  const auto nats = judges.ensemble.decide_all(three.pointers, three.seen);
  CHECK(batch->calls == 2);  // one for the verdicts, one for the decisions
  REQUIRE(verdicts.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto alone = judges.ensemble.judge(three.all[k], three.seen);
    CHECK(verdicts[k].nat == alone.nat);
    CHECK(verdicts[k].veto == alone.veto);
    CHECK(verdicts[k].scores.size() == alone.scores.size());
    CHECK(nats[k] == judges.ensemble.decide(three.all[k], three.seen));
  }
  CHECK(nats[2] - nats[0] == Approx(4));
}

TEST_CASE("no hypotheses are no question") {
  const Three three;
  const auto batch = std::make_shared<BatchOfIds>();
  const Judges judges(three.map, {{"ids", batch, ScorerRole::decides, 1}});
  CHECK(judges.ensemble.judge_all({}, three.seen).empty());
  CHECK(judges.ensemble.decide_all({}, three.seen).empty());
  CHECK(batch->calls == 0);
}

TEST_CASE("a batch of another size is no opinion, and is counted") {
  const Three three;
  const Judges judges(three.map, {always("a", 2), {"ids", std::make_shared<BatchOfIds>(1), ScorerRole::decides, 1}});
  CHECK(judges.ensemble.decide_all(three.pointers, three.seen) == std::vector<double>{2, 2, 2});
  CHECK(judges.failures.counts().at("ids") == 1);
}

TEST_CASE("of a batch only the score that is not finite is left out") {
  const Three three;
  const Judges judges(three.map, {{"ids", std::make_shared<BatchOfIds>(0, std::numeric_limits<double>::infinity()),
                                   ScorerRole::decides, 1}});
  CHECK(judges.ensemble.decide_all(three.pointers, three.seen) == std::vector<double>{0, 1, 2});
  CHECK(judges.failures.counts().at("ids") == 1);
}

TEST_CASE("a scorer that remembers is asked once, with the memory of each hypothesis") {
  Three three;
  const auto batch = std::make_shared<BatchOfMemories>();
  const Judges judges(three.map, {always("a", 2), {"remembers", batch, ScorerRole::decides, 1}});
  CHECK(judges.ensemble.decide_all(three.pointers, three.seen) == std::vector<double>{12, 12, 12});
  const auto verdicts = judges.ensemble.judge_all(three.pointers, three.seen);
  CHECK(batch->calls == 2);
  for (std::size_t k = 0; k < 3; ++k) judges.ensemble.remember(three.all[k], verdicts[k].scores, 0.5);
  CHECK(judges.ensemble.decide_all(three.pointers, three.seen) == std::vector<double>{12, 12.5, 13});
  CHECK(judges.ensemble.judge(three.all[2], three.seen).nat == 13);
}

TEST_CASE("a scorer that throws at one of many hypotheses says nothing of any, and is counted once") {
  const Three three;
  const auto choosy = std::make_shared<ToldScorer>([](const Hypothesis& hypothesis, const Observation&) {
    if (hypothesis.id == HypothesisId(1)) throw std::runtime_error("not this one");
    return Score{5, {}, {}};
  });
  const Judges judges(three.map, {always("a", 2), {"choosy", choosy, ScorerRole::decides, 1}});
  CHECK(judges.ensemble.decide_all(three.pointers, three.seen) == std::vector<double>{2, 2, 2});
  CHECK(judges.failures.counts().at("choosy") == 1);
  CHECK(judges.ensemble.decide(three.all[0], three.seen) == 7);
}
