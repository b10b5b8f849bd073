#include "benchmark/experiments/buildings/building_share.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/statistics/cluster_bootstrap.hpp"

#include <algorithm>
#include <cmath>

namespace opal::experiments {
namespace {

/// Variance of the share as the spread between buildings tells it, over that of independent trials; at
/// least 1.
double design_effect(std::span<const Tally> buildings, double share, double whole) {
  const double independent = share * (1 - share) / whole;
  if (buildings.size() < 2 || independent <= 0) return 1;
  double squares = 0;
  for (const Tally& building : buildings) squares += std::pow(building.part - share * building.whole, 2);
  const double m = static_cast<double>(buildings.size());
  return std::max(1.0, m / (m - 1) * squares / (whole * whole) / independent);
}

}  // namespace

BuildingShare share_over(std::span<const Tally> buildings) {
  double part = 0, whole = 0;
  for (const Tally& building : buildings) part += building.part, whole += building.whole;
  if (whole <= 0) return {};
  const double share = part / whole;
  return {share, wilson_interval(share, whole / design_effect(buildings, share, whole))};
}

BuildingMedian median_over(std::span<const std::vector<double>> buildings) {
  std::vector<double> values;
  std::vector<std::size_t> sizes;
  for (const std::vector<double>& some : buildings) {
    values.insert(values.end(), some.begin(), some.end());
    sizes.push_back(some.size());
  }
  BuildingMedian found{median(values), median_interval(values)};
  if (values.empty() || buildings.size() < 2) return found;
  const auto median_of = [&](const statistics::Weights& weights) {
    std::vector<double> sample;
    for (std::size_t k = 0; k < values.size(); ++k)
      sample.insert(sample.end(), static_cast<std::size_t>(weights[k]), values[k]);
    return median(std::move(sample));
  };
  statistics::BootstrapOptions options;
  options.samples = 1000;
  const statistics::Interval within =
      statistics::percentile_interval(statistics::bootstrap(sizes, median_of, options), 0.05);
  found.within = {within.low, within.high};
  return found;
}

}  // namespace opal::experiments
