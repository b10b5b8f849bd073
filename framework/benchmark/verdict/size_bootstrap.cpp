#include "benchmark/verdict/size_bootstrap.hpp"

#include "benchmark/statistics/cluster_bootstrap.hpp"
#include "benchmark/verdict/pair_scores.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

/// The median of a sample without drawing it: values in increasing order are passed until half of the weight is.
class WeightedMedian {
 public:
  explicit WeightedMedian(std::vector<double> values) : values_(std::move(values)), order_(values_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t j) { return values_[i] < values_[j]; });
  }

  double of(const Weights& weights) const {
    const int total = std::accumulate(weights.begin(), weights.end(), 0);
    return *median_of({at((total - 1) / 2, weights), at(total / 2, weights)});
  }

 private:
  double at(int rank, const Weights& weights) const {
    std::size_t i = 0;
    for (int passed = weights[order_[0]]; passed <= rank; passed += weights[order_[i]]) ++i;
    return values_[order_[i]];
  }

  std::vector<double> values_;
  std::vector<std::size_t> order_;
};

double weighted_mean(const std::vector<double>& values, const Weights& weights) {
  const double count = std::accumulate(weights.begin(), weights.end(), 0.0);
  return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) / count;
}

/// The size of the effect in a bootstrap sample.
Statistic size_of(Pairs pairs, Kind kind) {
  if (kind == Kind::distance_until)
    return [median = WeightedMedian(differences(pairs))](const Weights& weights) { return median.of(weights); };
  return [values = scores(pairs, kind), kind](const Weights& weights) {
    const double mean = weighted_mean(values, weights);
    return kind == Kind::cost ? std::exp(mean) : mean;
  };
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
  const bool clusters = sizes.size() >= kFewestDrawn;
  return percentile_interval(
      bootstrap(sizes, size_of(ordered.pairs, kind), {options.bootstrap_samples, options.seed, clusters}), level);
}

}  // namespace opal::statistics
