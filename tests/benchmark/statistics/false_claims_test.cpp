#include "simulated_experiment.hpp"

#include <catch2/catch.hpp>

#include <cstdio>

using namespace opal::statistics;

namespace {

constexpr double kLevel = 0.05;

/// In how many of so many simulated experiments something was claimed.
struct Claims {
  int experiments = 0;
  std::vector<int> by_metric = {0, 0, 0};  ///< each by itself, uncorrected
  int any = 0;                             ///< in the sentence, corrected over the metrics
  std::vector<int> by_pairs = {0, 0, 0};   ///< had pairs been taken as independent
  std::vector<int> by_sign_flip = {0, 0, 0};
  std::vector<int> uncovered = {0, 0, 0};  ///< interval without "no difference"
  int site = 0;                            ///< a site of the first metric by itself

  double share(int count) const { return static_cast<double>(count) / experiments; }
};

bool covers_nothing(const MetricResult& metric) {
  return metric.effect.interval.contains(metric.metric.kind == Metric::Kind::cost ? 1 : 0);
}

void count(const Verdict& verdict, Claims& claims) {
  bool any = false, site = false;
  for (std::size_t i = 0; i < verdict.metrics.size(); ++i) {
    const MetricResult& metric = verdict.metrics[i];
    claims.by_metric[i] += metric.p <= kLevel;
    claims.by_pairs[i] += metric.p_pairs <= kLevel;
    claims.by_sign_flip[i] += metric.p_sign_flip <= kLevel;
    claims.uncovered[i] += !covers_nothing(metric);
    any = any || metric.outcome == Outcome::better || metric.outcome == Outcome::worse;
  }
  for (const ClusterResult& cluster : verdict.metrics[0].clusters) site = site || cluster.outcome != Outcome::open;
  claims.any += any;
  claims.site += site;
  ++claims.experiments;
}

Claims claims_in(const SimulatedExperiment& experiment, int experiments) {
  Claims claims;
  for (int i = 0; i < experiments; ++i)
    count(compare(simulate(experiment, 1000 + static_cast<std::uint64_t>(i)), simulated_comparison()).front(), claims);
  return claims;
}

std::vector<std::size_t> sites(std::size_t count, std::size_t queries) {
  return std::vector<std::size_t>(count, queries);
}

void print(const Claims& c) {
  // decides | pairs independent | sign flips | interval without 0 || any claim, any site by itself
  for (const auto& counts : {c.by_metric, c.by_pairs, c.by_sign_flip, c.uncovered}) {
    for (const int n : counts) std::printf(" %5.1f", 100 * c.share(n));
    std::printf(" |");
  }
  std::printf(" %5.1f %5.1f\n", 100 * c.share(c.any), 100 * c.share(c.site));
  std::fflush(stdout);
}

}  // namespace

TEST_CASE("the same arm twice is told apart in three to seven of a hundred experiments") {
  constexpr int kExperiments = 200;
  for (const auto& cluster_sizes : {kRecordedSites, sites(7, 14), sites(40, 14)}) {
    const Claims claims = claims_in({cluster_sizes}, kExperiments);
    for (std::size_t metric = 0; metric < 3; ++metric) {
      // Of so few experiments one sigma is 1.5 %; [rates] shows the rates better.
      CAPTURE(cluster_sizes.size(), metric, claims.by_metric[metric]);
      CHECK(claims.share(claims.by_metric[metric]) >= 0.03);
      CHECK(claims.share(claims.by_metric[metric]) <= 0.07);
    }
    CHECK(claims.share(claims.any) <= 0.07);  // corrected for three metrics
  }
}

TEST_CASE("rates of false claims in 5,000 experiments, for docs/notebook/statistics_and_page.md", "[.][rates]") {
  constexpr int kExperiments = 5000;
  const auto show = [](const char* name, const std::vector<std::size_t>& cluster_sizes, double success,
                       double correlated) {
    SimulatedExperiment experiment{cluster_sizes};
    experiment.success = success;
    experiment.correlated = correlated;
    const Claims claims = claims_in(experiment, kExperiments);
    std::printf("%-9s success %.2f, correlated %.1f:", name, success, correlated);
    print(claims);
  };
  for (const double success : {0.6, 0.8, 0.95})
    for (const double correlated : {0.0, 0.2}) show("recorded", kRecordedSites, success, correlated);
  for (const double correlated : {0.0, 0.2}) show("3 x 33", sites(3, 33), 0.6, correlated);
  for (const double success : {0.6, 0.95}) show("40 x 14", sites(40, 14), success, 0.2);
  show("7 x 14", sites(7, 14), 0.6, 0.2);
}
