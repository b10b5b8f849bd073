#include "benchmark/statistics/cluster_bootstrap.hpp"

#include "common/random.hpp"

#include <opal/common/quantile.hpp>

#include <boost/math/distributions/normal.hpp>

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

std::vector<double> sorted_numbers(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::sort(values.begin(), values.end());
  return values;
}

double quantile_or_nan(std::span<const double> sorted, double share) {
  return quantile_of(sorted, share).value_or(std::numeric_limits<double>::quiet_NaN());
}

/// Efron (1987), equation 6.6; 0 if all are equal.
double acceleration(std::span<const double> jackknife) {
  const double mean = std::accumulate(jackknife.begin(), jackknife.end(), 0.0) / static_cast<double>(jackknife.size());
  double squares = 0, cubes = 0;
  for (const double value : jackknife) squares += std::pow(mean - value, 2), cubes += std::pow(mean - value, 3);
  return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
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
  const std::vector<double> sorted = sorted_numbers(std::move(values));
  return {quantile_or_nan(sorted, level / 2), quantile_or_nan(sorted, 1 - level / 2)};
}

Interval bca_interval(std::vector<double> values, double estimate, std::span<const double> jackknife, double level) {
  const std::vector<double> sorted = sorted_numbers(std::move(values));
  const double below = static_cast<double>(std::lower_bound(sorted.begin(), sorted.end(), estimate) - sorted.begin());
  const double equal = static_cast<double>(std::count(sorted.begin(), sorted.end(), estimate));
  const double share = (below + equal / 2) / static_cast<double>(sorted.size());
  if (!(share > 0 && share < 1) || jackknife.empty()) return percentile_interval(sorted, level);
  const boost::math::normal normal;
  const double bias = quantile(normal, share), a = acceleration(jackknife);
  const auto corrected = [&](double at) {
    const double z = bias + quantile(normal, at);
    return quantile_or_nan(sorted, cdf(normal, bias + z / (1 - a * z)));
  };
  return {corrected(level / 2), corrected(1 - level / 2)};
}

std::vector<double> jackknife(std::span<const std::size_t> cluster_sizes, const Statistic& statistic) {
  const std::vector<std::size_t> begin = begins(cluster_sizes);
  std::vector<double> values;
  for (std::size_t left_out = 0; left_out < cluster_sizes.size(); ++left_out) {
    Weights weights(total(cluster_sizes), 1);
    std::fill_n(weights.begin() + static_cast<std::ptrdiff_t>(begin[left_out]), cluster_sizes[left_out], 0);
    values.push_back(statistic(weights));
  }
  return values;
}

}  // namespace opal::statistics
