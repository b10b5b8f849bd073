#include "experiments/building_share.hpp"

#include "experiments/order_statistics.hpp"

#include <algorithm>
#include <random>

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
  constexpr std::size_t kSamples = 1000;
  std::vector<double> values, medians;
  for (const std::vector<double>& some : buildings) values.insert(values.end(), some.begin(), some.end());
  BuildingMedian found{median(values), median_interval(values)};
  if (values.empty() || buildings.size() < 2) return found;
  std::mt19937_64 random(1);
  while (medians.size() < kSamples) {
    values.clear();
    for (std::size_t k = 0; k < buildings.size(); ++k) {
      const std::vector<double>& some = buildings[random() % buildings.size()];
      values.insert(values.end(), some.begin(), some.end());
    }
    medians.push_back(median(values));
  }
  std::sort(medians.begin(), medians.end());
  found.within = {medians[kSamples / 40], medians[kSamples - 1 - kSamples / 40]};
  return found;
}

}  // namespace opal::experiments
