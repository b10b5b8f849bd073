#include "statistics/size_bootstrap.hpp"

#include "statistics/cluster_bootstrap.hpp"
#include "statistics/effect.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

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

}  // namespace

Interval size_interval(const PairedSample& sample, Kind kind, double level, const ComparisonOptions& options) {
  const PairedSample ordered{nameless_order(sample), 0};
  std::vector<std::size_t> sizes;
  for (const Pairs pairs : clusters_of(ordered)) sizes.push_back(pairs.size());
  const std::vector<double> values = kind == Kind::cost ? scores(ordered.pairs, kind) : differences(ordered.pairs);
  const auto statistic = [&](const Weights& weights) { return weighted_size(ordered.pairs, kind, values, weights); };
  const bool clusters = sizes.size() >= kFewestClusters;
  return percentile_interval(bootstrap(sizes, statistic, {options.bootstrap_samples, options.seed, clusters}), level);
}

}  // namespace opal::statistics
