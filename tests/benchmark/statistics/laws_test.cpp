#include "simulated_experiment.hpp"

#include "common/random.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace opal::statistics;

namespace {

ComparisonOptions with_bootstrap() {
  ComparisonOptions options = simulated_comparison();
  options.bootstrap_samples = 200;
  return options;
}

ResultsTable some_results(std::uint64_t seed, const std::vector<std::size_t>& sites) {
  SimulatedExperiment experiment{sites};
  experiment.planted = 0.4;
  experiment.cost_ratio = 1.1;
  return simulate(experiment, seed);
}

ResultsTable shuffled(ResultsTable table, std::uint64_t seed) {
  opal::Random random(seed);
  for (std::size_t i = table.size(); i > 1; --i) std::swap(table[i - 1], table[random.below(i)]);
  // Verdicts come in the order in which arms appear; there is one.
  return table;
}

/// Names in another order than before.
ResultsTable renamed(ResultsTable table) {
  for (ResultRow& row : table) {
    std::reverse(row.query.begin(), row.query.end());
    row.query = std::to_string(std::hash<std::string>{}(row.query)) + row.query;
  }
  return table;
}

void check_same(const MetricResult& x, const MetricResult& y) {
  CAPTURE(x.metric.name);
  CHECK(x.p == Approx(y.p).margin(1e-12));
  CHECK(x.p_corrected == Approx(y.p_corrected).margin(1e-12));
  CHECK(x.p_sign_flip == Approx(y.p_sign_flip).margin(1e-12));
  CHECK(x.effect.size == Approx(y.effect.size).margin(1e-12));
  CHECK(x.effect.interval.low == Approx(y.effect.interval.low).margin(1e-12));
  CHECK(x.effect.interval.high == Approx(y.effect.interval.high).margin(1e-12));
  CHECK(x.bootstrap.low == Approx(y.bootstrap.low).margin(1e-12));
  CHECK(x.bootstrap.high == Approx(y.bootstrap.high).margin(1e-12));
}

/// The size of the effect with the arms exchanged.
double opposite(const Metric& metric, double size) { return metric.kind == Metric::Kind::cost ? 1 / size : -size; }

Outcome opposite(Outcome outcome) {
  return outcome == Outcome::better ? Outcome::worse : outcome == Outcome::worse ? Outcome::better : outcome;
}

}  // namespace

TEST_CASE("the order of rows and the names of queries change nothing") {
  for (const auto& sites : {kRecordedSites, std::vector<std::size_t>{20, 13}}) {
    const ResultsTable table = some_results(3, sites);
    const Verdict before = compare(table, with_bootstrap()).front();
    for (const ResultsTable& other : {shuffled(table, 8), renamed(table), shuffled(renamed(table), 9)}) {
      const Verdict after = compare(other, with_bootstrap()).front();
      CHECK(after.sentence == before.sentence);
      for (std::size_t i = 0; i < before.metrics.size(); ++i) check_same(before.metrics[i], after.metrics[i]);
    }
  }
}

TEST_CASE("exchanging the arms turns every difference round and changes no p-value") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const ResultsTable table = some_results(seed, seed % 2 == 0 ? kRecordedSites : std::vector<std::size_t>{20, 13, 7});
    ComparisonOptions options = simulated_comparison();
    const Verdict forth = compare(table, options).front();
    options.baseline = "b";
    const Verdict back = compare(table, options).front();
    for (std::size_t i = 0; i < forth.metrics.size(); ++i) {
      const MetricResult &x = forth.metrics[i], &y = back.metrics[i];
      CAPTURE(seed, x.metric.name);
      CHECK(x.p == Approx(y.p).margin(1e-12));
      CHECK(x.p_pairs == Approx(y.p_pairs).margin(1e-12));
      CHECK(x.p_sign_flip == Approx(y.p_sign_flip).margin(1e-12));
      CHECK(x.effect.size == Approx(opposite(x.metric, y.effect.size)).margin(1e-9));
      CHECK(x.effect.interval.low == Approx(opposite(x.metric, y.effect.interval.high)).margin(1e-9));
      CHECK(x.effect.interval.high == Approx(opposite(x.metric, y.effect.interval.low)).margin(1e-9));
      CHECK(x.outcome == opposite(y.outcome));
      CHECK(x.more_queries == y.more_queries);
    }
  }
}

TEST_CASE("an arm beside its own copy: every p-value is 1, and nothing is claimed") {
  ResultsTable table = some_results(5, kRecordedSites);
  std::erase_if(table, [](const ResultRow& row) { return row.arm == "b"; });
  for (std::size_t i = 0, n = table.size(); i < n; ++i) {
    table.push_back(table[i]);
    table.back().arm = "b";
  }
  const Verdict verdict = compare(table, with_bootstrap()).front();
  for (const MetricResult& metric : verdict.metrics) {
    CAPTURE(metric.metric.name);
    CHECK(metric.p == 1);
    CHECK(metric.p_pairs == 1);
    CHECK(metric.p_sign_flip == 1);
    CHECK((metric.outcome == Outcome::equal || metric.outcome == Outcome::open));
    for (const ClusterResult& site : metric.clusters) CHECK(site.p_corrected == 1);
  }
}

TEST_CASE("more arms make every claim harder, and each gets its own verdict") {
  ResultsTable table = some_results(6, kRecordedSites);
  const Verdict alone = compare(table, simulated_comparison()).front();
  for (std::size_t i = 0, n = table.size(); i < n; ++i)
    if (table[i].arm == "a") {
      table.push_back(table[i]);
      table.back().arm = "c";
    }
  const auto verdicts = compare(table, simulated_comparison());
  REQUIRE(verdicts.size() == 2);
  CHECK(verdicts[0].arm == "b");
  CHECK(verdicts[1].arm == "c");
  for (std::size_t i = 0; i < alone.metrics.size(); ++i) {
    CHECK(verdicts[0].metrics[i].p == alone.metrics[i].p);
    CHECK(verdicts[0].metrics[i].p_corrected >= alone.metrics[i].p_corrected);
  }
}

TEST_CASE("an early look asks for more, and all looks together for hardly more than one") {
  const ResultsTable table = some_results(6, kRecordedSites);
  ComparisonOptions options = simulated_comparison();
  options.looks = 4;
  double before = 0;
  for (options.look = 1; options.look <= options.looks; ++options.look) {
    const Verdict verdict = compare(table, options).front();
    CHECK(verdict.level > before);
    CHECK(verdict.level < 0.05);
    before = verdict.level;
  }
  CHECK(before > 0.04);
}
