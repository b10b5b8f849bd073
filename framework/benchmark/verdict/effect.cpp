#include "benchmark/verdict/effect.hpp"

#include "benchmark/statistics/wilcoxon.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace opal::statistics {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double median_or_nan(std::vector<double> values) {
  return median_of(std::move(values)).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::vector<ClusterSum> sums_of(Pairs pairs, std::span<const double> scores, Independent independent) {
  return independent == Independent::clusters ? cluster_sums(pairs, scores) : single_sums(scores);
}

std::size_t nonzero(std::span<const double> scores) {
  return static_cast<std::size_t>(std::ranges::count_if(scores, [](double score) { return score != 0; }));
}

/// The cluster-robust t-test, but nothing that so few scores cannot carry.
double t_test(Pairs pairs, std::span<const double> scores, Independent independent) {
  return std::max(cluster_t_test(sums_of(pairs, scores, independent)), smallest_p(nonzero(scores)));
}

double mean_of(std::span<const double> scores) {
  return std::accumulate(scores.begin(), scores.end(), 0.0) / static_cast<double>(scores.size());
}

std::vector<double> side(Pairs pairs, double PairedValue::*value) {
  std::vector<double> values;
  for (const PairedValue& pair : pairs) values.push_back(pair.*value);
  return values;
}

Effect proportion_effect(Pairs pairs, Independent independent, double level) {
  const PairedCounts counts = counts_of(pairs);
  Interval interval = difference_interval(counts, level);
  if (independent == Independent::clusters) {
    const Interval between = cluster_t_interval(cluster_sums(pairs, differences(pairs)), level);
    const bool few = smallest_p(counts.discordant()) > level;
    interval = few ? Interval{std::min(interval.low, between.low), std::max(interval.high, between.high)} : between;
  }
  return {counts.share_a(),
          counts.share_b(),
          counts.difference(),
          {std::max(-1.0, interval.low), std::min(1.0, interval.high)}};
}

Effect cost_effect(Pairs pairs, Independent independent, double level) {
  const std::vector<double> logs = scores(pairs, Metric::Kind::cost);
  const Interval interval = cluster_t_interval(sums_of(pairs, logs, independent), level);
  return {median_or_nan(side(pairs, &PairedValue::a)),
          median_or_nan(side(pairs, &PairedValue::b)),
          std::exp(mean_of(logs)),
          {std::exp(interval.low), std::exp(interval.high)}};
}

/// Whether the signs of the differences about this one are as the test of them allows.
bool may_be_median(double candidate, Pairs pairs, std::span<const double> differences, Independent independent,
                   double level) {
  std::vector<double> signs;
  for (const double d : differences) signs.push_back(d > candidate ? 1 : d < candidate ? -1 : 0);
  return t_test(pairs, signs, independent) > level;
}

/// The lowest of the values that may be the median; what is between them makes no difference.
template <class Allowed>
double lowest(const std::vector<double>& values, std::size_t middle, const Allowed& allowed) {
  std::size_t refused = 0, low = middle;
  while (refused < low) {
    const std::size_t between = (refused + low) / 2;
    if (allowed(values[between]))
      low = between;
    else
      refused = between + 1;
  }
  return values[low];
}

Interval median_interval(Pairs pairs, Independent independent, double level) {
  const std::vector<double> all = differences(pairs);
  std::vector<double> values = all;
  std::ranges::sort(values);
  const double middle = values[values.size() / 2];
  const auto allowed = [&](double candidate) { return may_be_median(candidate, pairs, all, independent, level); };
  const auto end = [&](double infinite) {
    if (allowed(infinite)) return infinite;
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return lowest(values, static_cast<std::size_t>(std::ranges::find(values, middle) - values.begin()), allowed);
  };
  const double low = end(-kInfinite);
  std::ranges::reverse(values);
  return {low, end(kInfinite)};
}

Effect distance_effect(Pairs pairs, Independent independent, double level) {
  return {median_or_nan(side(pairs, &PairedValue::a)), median_or_nan(side(pairs, &PairedValue::b)),
          median_or_nan(differences(pairs)), median_interval(pairs, independent, level)};
}

double p_of_pairs(Pairs pairs, Metric::Kind kind) {
  if (kind == Metric::Kind::proportion) return mcnemar(counts_of(pairs)).mid;
  if (kind == Metric::Kind::distance_until) return wilcoxon(differences(pairs)).p;
  return t_test(pairs, scores(pairs, kind), Independent::pairs);
}

}  // namespace

Effect effect_of(Pairs pairs, Metric::Kind kind, Independent independent, double level) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  if (pairs.empty()) return {kUnknown, kUnknown, kUnknown, {-kInfinite, kInfinite}};
  if (kind == Metric::Kind::proportion) return proportion_effect(pairs, independent, level);
  if (kind == Metric::Kind::cost) return cost_effect(pairs, independent, level);
  return distance_effect(pairs, independent, level);
}

double p_of(Pairs pairs, Metric::Kind kind, Independent independent) {
  return independent == Independent::clusters ? t_test(pairs, scores(pairs, kind), independent)
                                              : p_of_pairs(pairs, kind);
}

PairedCounts counts_of(Pairs pairs) {
  PairedCounts counts;
  for (const PairedValue& pair : pairs) {
    if (pair.a > 0.5)
      ++(pair.b > 0.5 ? counts.both : counts.only_a);
    else
      ++(pair.b > 0.5 ? counts.only_b : counts.neither);
  }
  return counts;
}

}  // namespace opal::statistics
