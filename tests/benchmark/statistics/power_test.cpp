#include "simulated_experiment.hpp"

#include "benchmark/statistics/cluster_test.hpp"
#include "benchmark/statistics/power.hpp"
#include "benchmark/verdict/pair_scores.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace opal::statistics;

namespace {

constexpr int kExperiments = 300;
constexpr double kPowerLevel = 0.05;
constexpr double kMargin = 0.07;  // three sigmas of a share of 0.8 in 300 experiments

/// Share of experiments in which a difference in one metric is told, in favour of b.
double found(const SimulatedExperiment& experiment, std::size_t metric) {
  ComparisonOptions options = simulated_comparison();
  options.metrics = {options.metrics[metric]};
  int told = 0;
  for (int i = 0; i < kExperiments; ++i)
    told += compare(simulate(experiment, 5000 + static_cast<std::uint64_t>(i)), options).front().metrics[0].outcome ==
            Outcome::better;
  return static_cast<double>(told) / kExperiments;
}

/// Mean and standard deviation of what one site's pairs sum up to, from very many sites.
std::pair<double, double> site_sum(const SimulatedExperiment& experiment, const Metric& metric) {
  SimulatedExperiment many = experiment;
  many.cluster_sizes.assign(2000, experiment.cluster_sizes.front());
  const PairedSample sample = pair_rows(simulate(many, 77), metric, "a", "b");
  const auto sums = cluster_sums(sample.pairs, scores(sample.pairs, metric.kind));
  double total = 0, pairs = 0;
  for (const ClusterSum& site : sums) total += site.sum, pairs += site.pairs;
  const double sites = static_cast<double>(sums.size());
  return {total / sites, std::sqrt(variance_of_sum(sums, total / pairs) / sites)};
}

}  // namespace

TEST_CASE("a planted difference of costs is found with the stated power") {
  SimulatedExperiment experiment{std::vector<std::size_t>(8, 14)};
  experiment.cost_ratio = 0.92;
  const auto [mean, sigma] = site_sum(experiment, simulated_comparison().metrics[2]);
  const double power = t_test_power(mean / sigma, 8, kPowerLevel);
  CAPTURE(mean, sigma);
  CHECK(power > 0.6);
  CHECK(found(experiment, 2) == Approx(power).margin(kMargin));
}

TEST_CASE("a planted difference of success is found with power 0.8 by as many sites as are asked for") {
  SimulatedExperiment experiment{{14}};
  experiment.planted = 0.3;
  const auto [mean, sigma] = site_sum(experiment, simulated_comparison().metrics[0]);
  const double needed = units_for_power(mean / sigma, kPowerLevel, 0.8);
  CAPTURE(mean, sigma, needed);
  REQUIRE(needed > 10);
  REQUIRE(needed < 100);
  experiment.cluster_sizes.assign(static_cast<std::size_t>(needed), 14);
  CHECK(found(experiment, 0) == Approx(0.8).margin(kMargin));
}

TEST_CASE("more queries are asked for where less can be told") {
  const Metric success = simulated_comparison().metrics[0];
  double before = 0;
  for (const double planted : {0.6, 0.3, 0.15}) {
    SimulatedExperiment experiment{{14}};
    experiment.planted = planted;
    const auto [mean, sigma] = site_sum(experiment, success);
    const double needed = units_for_power(mean / sigma, kPowerLevel, 0.8);
    CHECK(needed > before);
    CHECK(units_for_power(mean / sigma, kPowerLevel / 3, 0.8) > needed);
    before = needed;
  }
}

TEST_CASE("no power comes of one unit, and a test without a difference finds its level") {
  CHECK(t_test_power(3, 1, kPowerLevel) == 0);
  CHECK(t_test_power(0, 7, kPowerLevel) == Approx(kPowerLevel));
  CHECK(std::isinf(units_for_power(0, kPowerLevel, 0.8)));
}
