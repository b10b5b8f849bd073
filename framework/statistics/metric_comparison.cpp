#include "statistics/metric_comparison.hpp"

#include "statistics/cluster_bootstrap.hpp"
#include "statistics/effect.hpp"
#include "statistics/holm.hpp"
#include "statistics/power.hpp"
#include "statistics/sign_flip.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

std::size_t count_if(Pairs pairs, const auto& holds) {
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), holds));
}

std::size_t count_better(Pairs pairs, const Metric& metric) {
  return count_if(pairs, [&](const PairedValue& pair) { return metric.higher_is_better ? pair.b > pair.a : pair.b < pair.a; });
}

std::size_t count_different(Pairs pairs) {
  return count_if(pairs, [](const PairedValue& pair) { return pair.a != pair.b; });
}

/// Size of no difference.
double neutral(Kind kind) { return kind == Kind::cost ? 1 : 0; }

/// Which way the mean score points: ranks may tell a difference whose median is 0.
Outcome direction(double mean_score, const Metric& metric) {
  return (mean_score > 0) == metric.higher_is_better ? Outcome::better : Outcome::worse;
}

double sum_of(const std::vector<double>& scores) { return std::accumulate(scores.begin(), scores.end(), 0.0); }

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
    if (result.p_corrected <= level) result.outcome = direction(sum_of(scores(pairs, metric.kind)), metric);
  }
  return results;
}

/// The size of the effect in a bootstrap sample.
double weighted_size(Pairs pairs, Kind kind, std::span<const double> values, const Weights& weights) {
  if (kind == Kind::distance_until) {
    std::vector<double> drawn;
    for (std::size_t i = 0; i < pairs.size(); ++i) drawn.insert(drawn.end(), static_cast<std::size_t>(weights[i]), values[i]);
    return median(std::move(drawn));
  }
  const double count = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double mean = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) / count;
  return kind == Kind::cost ? std::exp(mean) : mean;
}

/// Clusters and their pairs in an order that names do not change, as drawing depends on it.
std::vector<PairedValue> nameless_order(const PairedSample& sample) {
  std::vector<std::vector<PairedValue>> clusters;
  const auto values = [](const PairedValue& pair) { return std::make_pair(pair.a, pair.b); };
  const auto less = [&](const PairedValue& x, const PairedValue& y) { return values(x) < values(y); };
  for (const Pairs pairs : clusters_of(sample)) {
    clusters.emplace_back(pairs.begin(), pairs.end());
    std::sort(clusters.back().begin(), clusters.back().end(), less);
  }
  std::sort(clusters.begin(), clusters.end(), [&](const auto& x, const auto& y) {
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end(), less);
  });
  std::vector<PairedValue> all;
  for (const auto& cluster : clusters) all.insert(all.end(), cluster.begin(), cluster.end());
  return all;
}

Interval bootstrap_interval(const PairedSample& sample, Kind kind, double level, const ComparisonOptions& options) {
  const PairedSample ordered{nameless_order(sample), 0};
  std::vector<std::size_t> sizes;
  for (const Pairs pairs : clusters_of(ordered)) sizes.push_back(pairs.size());
  const std::vector<double> values = kind == Kind::cost ? scores(ordered.pairs, kind) : differences(ordered.pairs);
  const auto statistic = [&](const Weights& weights) { return weighted_size(ordered.pairs, kind, values, weights); };
  const bool clusters = sizes.size() >= kFewestClusters;
  return percentile_interval(bootstrap(sizes, statistic, {options.bootstrap_samples, options.seed, clusters}), level);
}

double sign_flip_p(const PairedSample& sample, Kind kind) {
  std::vector<double> sums;
  for (const ClusterSum& cluster : cluster_sums(sample.pairs, scores(sample.pairs, kind))) sums.push_back(cluster.sum);
  return sign_flip_test(sums);
}

/// As a mean score; of a distance the one seen, as ranks have no metres.
double score_to_tell(const MetricResult& result, double mean_score) {
  if (result.metric.kind == Kind::distance_until) return std::abs(mean_score);
  const double interesting = of_interest(result.metric);
  return std::max(std::abs(mean_score), result.metric.kind == Kind::cost ? std::log1p(interesting) : interesting);
}

/// Of a mean score, or of the difference that is as far from nothing.
double as_size(Kind kind, double score) { return kind == Kind::cost ? std::expm1(score) : score; }

/// Variance of all scores' sum if the pairs were independent; a proportion's is not zero though no pair differs.
double variance_by_pairs(const MetricResult& result, std::span<const double> scores, double mean) {
  const double n = static_cast<double>(scores.size());
  if (result.metric.kind == Kind::proportion) return n * (static_cast<double>(result.counts.discordant()) + 1) / (n + 2);
  return variance_of_sum(single_sums(scores), mean);
}

/// Fewest more queries of which the test at this level has power 0.8, at least one more unit.
double more_queries(double score, double variance_of_all, double units, double pairs, double level) {
  constexpr double kPower = 0.8;
  const double per_unit = pairs / units;
  if (!(variance_of_all > 0) || !(score > 0)) return score > 0 ? per_unit : std::numeric_limits<double>::infinity();
  const double sigmas = score * per_unit / std::sqrt(variance_of_all / units);
  return std::max(1.0, units_for_power(sigmas, level, kPower) - units) * per_unit;
}

void plan_more(MetricResult& result, const PairedSample& sample, double level) {
  const std::vector<double> all = scores(sample.pairs, result.metric.kind);
  if (all.size() < 2) {
    result.more_queries = std::numeric_limits<double>::infinity();
    return;
  }
  const double mean = sum_of(all) / static_cast<double>(all.size()), by_pairs = variance_by_pairs(result, all, mean);
  const std::vector<ClusterSum> sums = cluster_sums(sample.pairs, all);
  if (sums.size() > 1) result.design_effect = design_effect(variance_of_sum(sums, mean), by_pairs);
  const double score = score_to_tell(result, mean);
  result.told = as_size(result.metric.kind, score);
  const double inflated = by_pairs * (result.between_clusters ? std::max(1.0, result.design_effect) : 1.0);
  const double units = static_cast<double>(result.between_clusters ? sums.size() : all.size());
  result.more_queries = more_queries(score, inflated, units, static_cast<double>(all.size()), level);
}

/// Whether the interval has no difference that is of interest.
bool no_difference_of_interest(const MetricResult& result) {
  const double most = of_interest(result.metric);
  const Interval& interval = result.effect.interval;
  if (result.metric.kind == Kind::cost) return interval.low >= 1 / (1 + most) && interval.high <= 1 + most;
  return interval.low >= -most && interval.high <= most;
}

}  // namespace

double of_interest(const Metric& metric) {
  if (metric.of_interest > 0) return metric.of_interest;
  return metric.kind == Kind::proportion ? 0.02 : metric.kind == Kind::distance_until ? 0.5 : 0.05;
}

MetricResult compare_metric(const PairedSample& sample, const Metric& metric, double level, const ComparisonOptions& options) {
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
  result.bootstrap = bootstrap_interval(sample, metric.kind, level, options);
  if (metric.kind == Kind::proportion) {
    result.counts = counts_of(pairs);
    result.odds_ratio = matched_odds_ratio(result.counts);
    result.odds_ratio_interval = matched_odds_ratio_interval(result.counts, level);
  }
  return result;
}

void conclude(MetricResult& result, const PairedSample& sample, double level, std::size_t tests) {
  plan_more(result, sample, level / static_cast<double>(tests));
  if (result.pairs == 0) return;
  if (result.p_corrected <= level)
    result.outcome = direction(sum_of(scores(sample.pairs, result.metric.kind)), result.metric);
  else if (no_difference_of_interest(result))
    result.outcome = Outcome::equal;
}

}  // namespace opal::statistics
