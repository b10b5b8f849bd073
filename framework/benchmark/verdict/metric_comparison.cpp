#include "benchmark/verdict/metric_comparison.hpp"

#include "benchmark/statistics/holm.hpp"
#include "benchmark/statistics/sign_flip.hpp"
#include "benchmark/verdict/conclusion.hpp"
#include "benchmark/verdict/effect.hpp"
#include "benchmark/verdict/size_bootstrap.hpp"

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

std::size_t count_if(Pairs pairs, const auto& holds) {
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), holds));
}

std::size_t count_better(Pairs pairs, const Metric& metric) {
  return count_if(pairs,
                  [&](const PairedValue& pair) { return metric.higher_is_better ? pair.b > pair.a : pair.b < pair.a; });
}

std::size_t count_different(Pairs pairs) {
  return count_if(pairs, [](const PairedValue& pair) { return pair.a != pair.b; });
}

ClusterResult cluster_result(Pairs pairs, const Metric& metric, double level) {
  ClusterResult result{pairs.front().cluster, pairs.size(), count_better(pairs, metric), 0, {}, 1, 1, Outcome::open};
  result.worse = count_different(pairs) - result.better;
  result.effect = effect_of(pairs, metric.kind, Independent::pairs, level);
  result.p = p_of(pairs, metric.kind, Independent::pairs);
  return result;
}

void correct(std::vector<ClusterResult>& results) {
  std::vector<double> p;
  for (const ClusterResult& result : results) p.push_back(result.p);
  const std::vector<double> corrected = holm(p);
  for (std::size_t i = 0; i < results.size(); ++i) results[i].p_corrected = corrected[i];
}

std::vector<ClusterResult> cluster_results(const PairedSample& sample, const Metric& metric, double level) {
  std::vector<ClusterResult> results;
  for (const Pairs pairs : clusters_of(sample)) results.push_back(cluster_result(pairs, metric, level));
  correct(results);
  std::size_t i = 0;
  for (const Pairs pairs : clusters_of(sample)) {
    ClusterResult& result = results[i++];
    if (result.p_corrected <= level) result.outcome = direction(pairs, metric);
  }
  return results;
}

double sign_flip_p(const PairedSample& sample, Kind kind) {
  std::vector<double> sums;
  for (const ClusterSum& cluster : cluster_sums(sample.pairs, scores(sample.pairs, kind))) sums.push_back(cluster.sum);
  return sign_flip_test(sums);
}

}  // namespace

MetricResult compare_metric(const PairedSample& sample, const Metric& metric, double level,
                            const ComparisonOptions& options) {
  MetricResult result;
  const Pairs pairs = sample.pairs;
  result.metric = metric;
  result.pairs = pairs.size();
  result.left_out = sample.left_out;
  result.better = count_better(pairs, metric);
  result.worse = count_different(pairs) - result.better;
  result.never_a = count_if(pairs, [](const PairedValue& pair) { return std::isinf(pair.a); });
  result.never_b = count_if(pairs, [](const PairedValue& pair) { return std::isinf(pair.b); });
  result.clusters = cluster_results(sample, metric, level);
  result.between_clusters = result.clusters.size() >= kFewestClusters;
  const Independent independent = result.between_clusters ? Independent::clusters : Independent::pairs;
  result.effect = effect_of(pairs, metric.kind, independent, level);
  result.p = p_of(pairs, metric.kind, independent);
  result.p_pairs = p_of(pairs, metric.kind, Independent::pairs);
  result.p_sign_flip = sign_flip_p(sample, metric.kind);
  result.bootstrap = size_interval(sample, metric.kind, level, options);
  if (metric.kind == Kind::proportion) {
    result.counts = counts_of(pairs);
    result.odds_ratio = matched_odds_ratio(result.counts);
    result.odds_ratio_interval = matched_odds_ratio_interval(result.counts, level);
  }
  return result;
}

}  // namespace opal::statistics
