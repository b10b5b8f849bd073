#include "benchmark/statistics/share_bound.hpp"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

ClusterCount sum_of(std::span<const ClusterCount> clusters) {
  ClusterCount all;
  for (const ClusterCount& cluster : clusters) all.part += cluster.part, all.whole += cluster.whole;
  return all;
}

/// So much smaller is a sample whose spread few clusters tell.
double share_of_freedom(double trials, std::size_t clusters, double level) {
  if (clusters < 2 || trials <= static_cast<double>(clusters)) return 1;
  const auto width = [&](double freedom) {
    return quantile(complement(boost::math::students_t_distribution<>(freedom), level / 2));
  };
  return std::pow(width(trials - 1) / width(static_cast<double>(clusters) - 1), 2);
}

}  // namespace

double design_effect(std::span<const ClusterCount> clusters) {
  const ClusterCount all = sum_of(clusters);
  const double share = all.whole > 0 ? all.part / all.whole : 0;
  const double independent = share * (1 - share) / std::max(all.whole, 1.0);
  if (clusters.size() < 2 || independent <= 0) return 1;
  double squares = 0;
  for (const ClusterCount& cluster : clusters) squares += std::pow(cluster.part - share * cluster.whole, 2);
  const double m = static_cast<double>(clusters.size());
  return std::max(1.0, m / (m - 1) * squares / (all.whole * all.whole) / independent);
}

Interval share_interval(std::span<const ClusterCount> clusters, double level) {
  const ClusterCount all = sum_of(clusters);
  if (all.whole <= 0) return {0, 1};
  const double share = share_of_freedom(all.whole, clusters.size(), level) / design_effect(clusters);
  const double part = share * all.part, rest = share * (all.whole - all.part);
  using boost::math::beta_distribution;
  const double low = part <= 0 ? 0 : quantile(beta_distribution<>(part, rest + 1), level / 2);
  const double high = rest <= 0 ? 1 : quantile(complement(beta_distribution<>(part + 1, rest), level / 2));
  return {low, high};
}

}  // namespace opal::statistics
