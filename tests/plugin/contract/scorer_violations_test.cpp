// The contract of scorers: small offenders, each of which breaks one promise.
#include "tests/plugin/contract/sentences.hpp"

#include <opal/plugin/testing/scorer_contract.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>

using namespace opal;
using Catch::Contains;

TEST_CASE("a scorer that breaks a promise is told which") {
  struct Scorer final : HypothesisScorer {
    std::function<double(const Hypothesis&, const Observation&)> judge;
    bool by_associations = true;
    bool judges_associations() const override { return by_associations; }
    Score score(const Hypothesis& hypothesis, const Observation& seen, const MapView&,
                const ScorerMemory*) const override {
      return {judge(hypothesis, seen), "", {}};
    }
  };
  Scorer scorer;
  const auto offences = [&](auto&& judge) {
    scorer.judge = judge;
    return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}}));
  };
  CHECK(offences([](const Hypothesis& h, const Observation&) {
          return 0.1 * static_cast<double>(h.associations.size());
        }) == "");
  CHECK_THAT(offences([](const Hypothesis& h, const Observation&) { return h.T_map_local.x(); }),
             Contains("after map and hypothesis were moved together"));
  CHECK_THAT(offences([](const Hypothesis&, const Observation& seen) {
               return 1 - std::log(static_cast<double>(seen.points()));
             }),
             Contains("of an empty observation a score of inf"));
  double calls = 0;
  CHECK_THAT(offences([&](const Hypothesis&, const Observation&) { return ++calls; }),
             Contains("another score when it is asked again"));
  scorer.by_associations = false;
  CHECK_THAT(offences([](const Hypothesis& h, const Observation&) {
               return 0.1 * static_cast<double>(h.associations.size());
             }),
             Contains("another score than without its associations, which it says it does not judge"));
  CHECK(offences([](const Hypothesis&, const Observation& seen) { return static_cast<double>(seen.points()); }) == "");
}

TEST_CASE("a scorer that judges many hypotheses otherwise than one is told so") {
  struct Scorer final : HypothesisScorer {
    double surplus_nat = 0;
    std::size_t surplus_scores = 0;
    Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
      return {1, {}, {}};
    }
    std::vector<Score> score_all(std::span<const Hypothesis* const> hypotheses, std::span<const ScorerMemory* const>,
                                 const Observation&, const MapView&) const override {
      return std::vector<Score>(hypotheses.size() + surplus_scores, Score{1 + surplus_nat, {}, {}});
    }
  };
  Scorer scorer;
  const auto offences = [&] { return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}})); };
  CHECK(offences() == "");
  scorer.surplus_nat = 0.001;
  CHECK_THAT(offences(), Contains("gives the true hypothesis another score when it judges many in one call"));
  scorer.surplus_nat = 0;
  scorer.surplus_scores = 1;
  CHECK_THAT(offences(), Contains("gives 8 scores for 7 hypotheses in one call"));
}

TEST_CASE("a scorer that explains itself badly is told so") {
  struct Scorer final : HypothesisScorer {
    Finding finding;
    Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory*) const override {
      return {};
    }
    std::vector<Finding> explain(const Hypothesis&, const Observation&, const MapView&) const override {
      return {finding};
    }
  };
  const auto offences = [](const Finding& finding) {
    Scorer scorer;
    scorer.finding = finding;
    return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}}));
  };
  CHECK(offences({"a beam passes through a wall", MapFeatureNumber(0), {{0, 0}, {1, 0}}}) == "");
  CHECK_THAT(offences({"", {}, {}}), Contains("a finding without words"));
  CHECK_THAT(offences({"something", MapFeatureNumber(100000), {}}), Contains("a mapped feature that does not exist"));
  CHECK_THAT(offences({"something", {}, {{0, 0}, {std::nan(""), 0}}}), Contains("not two finite points"));
}

namespace {

/// How many scans a hypothesis has seen. Broken ones share the count between copies.
struct Count final : ScorerMemory {
  std::shared_ptr<double> scans = std::make_shared<double>(0);
  std::function<std::unique_ptr<ScorerMemory>(const Count&)> copied = independent;

  static std::unique_ptr<ScorerMemory> independent(const Count& count) {
    auto copy = std::make_unique<Count>(count);
    copy->scans = std::make_shared<double>(*count.scans);
    return copy;
  }
  std::unique_ptr<ScorerMemory> copy() const override { return copied(*this); }
};

/// An honest scorer with a memory, whose single steps can be replaced by broken ones.
struct CountingScorer final : HypothesisScorer {
  std::function<std::unique_ptr<ScorerMemory>()> make = [] { return std::make_unique<Count>(); };
  std::function<double(double&)> judge = [](double& scans) { return 1 / (1 + scans); };
  std::function<void(double&, double)> add = [](double& scans, double weight) { scans += weight; };
  std::function<void(double&, double)> forget = [](double& scans, double weight) { scans *= 1 - 0.1 * weight; };

  static double& scans_of(const ScorerMemory& memory) { return *dynamic_cast<const Count&>(memory).scans; }
  std::unique_ptr<ScorerMemory> new_memory(const MapView&) const override { return make(); }
  Score score(const Hypothesis&, const Observation&, const MapView&, const ScorerMemory* memory) const override {
    double nothing = 0;
    return {judge(memory ? scans_of(*memory) : nothing), "", {}, std::make_shared<Count>()};
  }
  void remember(ScorerMemory& memory, const ScorerMemory&, double weight) const override {
    add(scans_of(memory), weight);
  }
  void fade(ScorerMemory& memory, double weight) const override { forget(scans_of(memory), weight); }
};

std::string memory_offences(const std::function<void(CountingScorer&)>& change) {
  CountingScorer scorer;
  change(scorer);
  return text(testing::scorer_violations(scorer, {"acme:Scorer", {}, {}}));
}

/// The offences of a scorer whose memory copies itself in this way.
std::string copy_offences(std::function<std::unique_ptr<ScorerMemory>(const Count&)> copied) {
  return memory_offences([&](CountingScorer& scorer) {
    scorer.make = [copied] {
      auto count = std::make_unique<Count>();
      count->copied = copied;
      return count;
    };
  });
}

}  // namespace

TEST_CASE("an honest scorer with a memory breaks no promise") {
  CHECK(memory_offences([](CountingScorer&) {}) == "");
}

TEST_CASE("a scorer whose memory does not copy itself well is told so") {
  struct Other final : ScorerMemory {
    std::unique_ptr<ScorerMemory> copy() const override { return std::make_unique<Other>(); }
  };
  CHECK_THAT(copy_offences([](const Count&) { return nullptr; }), Contains("a memory whose copy is null"));
  CHECK_THAT(copy_offences([](const Count&) { return std::make_unique<Other>(); }),
             Contains("a memory whose copy is of another type"));
  CHECK_THAT(copy_offences([](const Count&) { return std::make_unique<Count>(); }),
             Contains("another score with a copy of its memory"));
  CHECK_THAT(copy_offences([](const Count& count) { return std::make_unique<Count>(count); }),
             Contains("another score after a copy of its memory has remembered a scan and faded"));
}

TEST_CASE("a scorer that uses its memory badly is told how") {
  CHECK_THAT(memory_offences([](CountingScorer& s) { s.judge = [](double& scans) { return ++scans; }; }),
             Contains("another score when the same memory is used again"));
  CHECK_THAT(
      memory_offences([](CountingScorer& s) { s.add = [](double&, double) { throw std::runtime_error("full"); }; }),
      Contains("throws on remembering a scan of the true hypothesis: full"));
  CHECK_THAT(
      memory_offences([](CountingScorer& s) { s.forget = [](double&, double) { throw std::runtime_error("never"); }; }),
      Contains("throws on fading the memory of the true hypothesis: never"));
  CHECK_THAT(
      memory_offences([](CountingScorer& s) { s.forget = [](double& scans, double weight) { scans /= 1 - weight; }; }),
      Contains("after it has remembered some scans"));
}

TEST_CASE("a scorer that cannot make up its mind about having a memory is told so") {
  CHECK_THAT(memory_offences([](CountingScorer& s) { s.make = [] { return nullptr; }; }),
             Contains("says what it has seen of the true hypothesis, but makes no new memory to remember it in"));
  int made = 0;
  CHECK_THAT(memory_offences([&](CountingScorer& s) {
               s.make = [&]() -> std::unique_ptr<ScorerMemory> {
                 return ++made % 2 == 0 ? std::make_unique<Count>() : nullptr;
               };
             }),
             Contains("makes a new memory of a map at one time and none at another"));
}
