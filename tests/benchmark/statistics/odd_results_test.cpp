#include "benchmark/verdict/comparison.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace opal::statistics;
using Catch::Contains;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kNever = std::numeric_limits<double>::infinity();

ResultRow row(const std::string& arm, const std::string& cluster, int query, double success, double distance_m,
              double cpu_ms) {
  return {
      arm, cluster, std::to_string(query), 1, {{"success", success}, {"distance_m", distance_m}, {"cpu_ms", cpu_ms}},
      ""};
}

ComparisonOptions options() {
  ComparisonOptions all;
  all.baseline = "a";
  all.metrics = {{"success", Metric::Kind::proportion, true, "", "localizes in", 0},
                 {"distance_m", Metric::Kind::distance_until, false, "m", "", 0},
                 {"cpu_ms", Metric::Kind::cost, false, "ms", "CPU", 0}};
  all.bootstrap_samples = 50;
  return all;
}

void check_sane(const Verdict& verdict) {
  CHECK_FALSE(verdict.sentence.empty());
  CHECK_THAT(verdict.sentence, !Contains("nan") && !Contains("inf"));
  for (const MetricResult& metric : verdict.metrics) {
    CAPTURE(metric.metric.name);
    CHECK(metric.p >= 0);
    CHECK(metric.p <= 1);
    CHECK(metric.p_corrected >= metric.p);
    CHECK_FALSE(metric.effect.interval.low > metric.effect.interval.high);
    if (metric.pairs > 0) CHECK(metric.effect.interval.contains(metric.effect.size));
  }
}

std::string message_of(const ResultsTable& table) {
  return opal::refused_with<opal::Error>([&] { compare(table, options()); });
}

}  // namespace

TEST_CASE("one query, or one site, is an experiment that tells little") {
  for (const int queries : {1, 2, 9}) {
    ResultsTable table;
    for (int query = 0; query < queries; ++query) {
      table.push_back(row("a", "hall", query, 0, kNever, 1.0));
      table.push_back(row("b", "hall", query, 1, 2.0, 1.5));
    }
    const Verdict verdict = compare(table, options()).front();
    check_sane(verdict);
    CHECK_THAT(verdict.sentence, Contains("Said of this site only"));
    CHECK_FALSE(verdict.metrics[0].between_clusters);
    if (queries < 6)
      CHECK(verdict.metrics[0].outcome == Outcome::open);
    else
      CHECK(verdict.metrics[0].outcome == Outcome::better);
  }
}

TEST_CASE("results without numbers, all equal, all failed") {
  const std::vector<std::string> sites{"s1", "s2", "s3", "s4", "s5", "s6", "s7"};
  const auto all = [&](double success, double distance_m, double cpu_ms, const std::string& failure) {
    ResultsTable table;
    for (const std::string& site : sites)
      for (int query = 0; query < 5; ++query)
        for (const std::string arm : {"a", "b"}) {
          table.push_back(row(arm, site, query, success, distance_m, cpu_ms));
          if (arm == "b") table.back().failure = failure;
        }
    return compare(table, options()).front();
  };
  check_sane(all(kNan, kNan, kNan, ""));
  check_sane(all(1, 0, 2, ""));
  check_sane(all(0, kNever, 0, ""));
  const Verdict crashed = all(1, 0, 2, "crashed: signal 11");
  check_sane(crashed);
  CHECK(crashed.failures == 35);
  CHECK(crashed.metrics[0].outcome == Outcome::worse);
  CHECK(crashed.metrics[1].outcome == Outcome::worse);
  CHECK(crashed.metrics[2].pairs == 0);
  CHECK(crashed.metrics[2].left_out == 35);
}

TEST_CASE("what was never reached ranks behind every distance, and two of it are equal") {
  ResultsTable table;
  for (int query = 0; query < 12; ++query) {
    table.push_back(row("a", "hall", query, 1, query < 6 ? kNan : 30, 1));
    table.push_back(row("b", "hall", query, 1, query < 3 ? kNever : 29, 1));
  }
  const MetricResult distance = compare(table, options()).front().metrics[1];
  CHECK(distance.never_a == 6);
  CHECK(distance.never_b == 3);
  CHECK(distance.better == 9);
  CHECK(distance.worse == 0);
  CHECK(distance.effect.size == -1);
  CHECK(distance.outcome == Outcome::better);
}

TEST_CASE("arms that were asked different things are not compared") {
  const ResultsTable good{row("a", "hall", 1, 1, 0, 1), row("b", "hall", 1, 1, 0, 1)};
  CHECK(message_of(good) == "accepted");
  ResultsTable more = good;
  more.push_back(row("b", "hall", 2, 1, 0, 1));
  CHECK(message_of(more) == "results: hall, query 2, seed 1 is there for arm b but not for arm a, expected for both");
  ResultsTable twice = good;
  twice.push_back(good[1]);
  CHECK(message_of(twice) == "results of arm b: hall, query 1, seed 1 is there twice, expected once");
  ResultsTable share = good;
  share[1].values["success"] = 0.5;
  CHECK_THAT(message_of(share), Contains("success is 0.5") && Contains("expected 0 or 1"));
  CHECK_THAT(message_of({good[1]}), Contains("no result of the baseline a"));
  CHECK(compare({good[0]}, options()).empty());
}
