#include "benchmark/statistics/cluster_bootstrap.hpp"

#include "common/random.hpp"

#include <opal/common/quantile.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace opal::statistics {
namespace {

std::size_t total(std::span<const std::size_t> sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
}

/// Where each cluster's pairs begin.
std::vector<std::size_t> begins(std::span<const std::size_t> sizes) {
  std::vector<std::size_t> begin(sizes.size(), 0);
  std::exclusive_scan(sizes.begin(), sizes.end(), begin.begin(), std::size_t{0});
  return begin;
}

void add(Weights& weights, std::size_t begin, std::size_t count) {
  for (std::size_t i = begin; i < begin + count; ++i) ++weights[i];
}

Weights draw_clusters(std::span<const std::size_t> sizes, std::span<const std::size_t> begin, Random& random) {
  Weights weights(total(sizes), 0);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::size_t drawn = random.below(sizes.size());
    add(weights, begin[drawn], sizes[drawn]);
  }
  return weights;
}

Weights draw_pairs(std::span<const std::size_t> sizes, std::span<const std::size_t> begin, Random& random) {
  Weights weights(total(sizes), 0);
  for (std::size_t cluster = 0; cluster < sizes.size(); ++cluster)
    for (std::size_t i = 0; i < sizes[cluster]; ++i) add(weights, begin[cluster] + random.below(sizes[cluster]), 1);
  return weights;
}

double quantile_or_nan(std::span<const double> sorted, double share) {
  return quantile_of(sorted, share).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

std::vector<double> bootstrap(std::span<const std::size_t> cluster_sizes, const Statistic& statistic,
                              const BootstrapOptions& options) {
  const std::vector<std::size_t> begin = begins(cluster_sizes);
  Random random(options.seed);
  std::vector<double> values;
  if (total(cluster_sizes) == 0) return values;
  for (int sample = 0; sample < options.samples; ++sample)
    values.push_back(statistic(options.clusters ? draw_clusters(cluster_sizes, begin, random)
                                                : draw_pairs(cluster_sizes, begin, random)));
  return values;
}

Interval percentile_interval(std::vector<double> values, double level) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::sort(values.begin(), values.end());
  return {quantile_or_nan(values, level / 2), quantile_or_nan(values, 1 - level / 2)};
}

}  // namespace opal::statistics
