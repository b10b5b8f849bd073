#include "benchmark/verdict/conclusion.hpp"

#include "benchmark/statistics/power.hpp"
#include "benchmark/verdict/pair_scores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

double sum_of(const std::vector<double>& scores) { return std::accumulate(scores.begin(), scores.end(), 0.0); }

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
  if (result.metric.kind == Kind::proportion)
    return n * (static_cast<double>(result.counts.discordant()) + 1) / (n + 2);
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

Outcome direction(Pairs pairs, const Metric& metric) {
  return (sum_of(scores(pairs, metric.kind)) > 0) == metric.higher_is_better ? Outcome::better : Outcome::worse;
}

void conclude(MetricResult& result, const PairedSample& sample, double level, std::size_t tests) {
  plan_more(result, sample, level / static_cast<double>(tests));
  if (result.pairs == 0) return;
  if (result.p_corrected <= level)
    result.outcome = direction(sample.pairs, result.metric);
  else if (no_difference_of_interest(result))
    result.outcome = Outcome::equal;
}

}  // namespace opal::statistics
