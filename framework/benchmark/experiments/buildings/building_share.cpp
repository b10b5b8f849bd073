#include "benchmark/experiments/buildings/building_share.hpp"

#include "benchmark/experiments/kit/order_statistics.hpp"
#include "benchmark/statistics/cluster_bootstrap.hpp"

namespace opal::experiments {

BuildingShare share_over(std::span<const Tally> buildings) {
  double part = 0, whole = 0;
  for (const Tally& building : buildings) part += building.part, whole += building.whole;
  if (whole <= 0) return {};
  const double share = part / whole;
  return {share, wilson_interval(share, whole / statistics::design_effect(buildings))};
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
