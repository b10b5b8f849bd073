#pragma once

#include "benchmark/statistics/interval.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace opal::statistics {

/// How often each pair is in a sample; pairs in the order of their clusters.
using Weights = std::vector<int>;
using Statistic = std::function<double(const Weights&)>;

/// Which pairs belong together, and how they are drawn again (Efron & Tibshirani 1993; clusters: Cameron, Gelbach &
/// Miller 2008).
struct BootstrapOptions {
  int samples = 4000;
  std::uint64_t seed = 1;
  bool clusters =
      true;  ///< draw whole clusters; else pairs within each cluster, which says nothing about other clusters
};

/// The statistic of samples drawn with replacement. Deterministic: the same seed, sizes and statistic give the same
/// values.
std::vector<double> bootstrap(std::span<const std::size_t> cluster_sizes, const Statistic& statistic,
                              const BootstrapOptions& options);

/// Of the values, the ends that leave level / 2 out at each side, interpolated linearly (opal/common/quantile.hpp);
/// NaN are not counted. With few clusters it is too narrow: docs/ab_statistics.md has its coverage.
Interval percentile_interval(std::vector<double> values, double level);

}  // namespace opal::statistics
