#include "benchmark/statistics/wilcoxon.hpp"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace opal::statistics {
namespace {

double normal_p(std::span<const double> ranks, double statistic) {
  const double variance = std::inner_product(ranks.begin(), ranks.end(), ranks.begin(), 0.0);
  if (variance == 0) return 1;
  return 2 * cdf(complement(boost::math::normal(), std::abs(statistic) / std::sqrt(variance)));
}

/// How probable each sum of those ranks is that get a plus by a fair coin; index: twice the sum, as shared ranks are
/// halves.
std::vector<double> distribution(std::span<const double> ranks) {
  std::vector<double> probability{1};
  for (const double rank : ranks) {
    const std::size_t step = static_cast<std::size_t>(std::lround(2 * std::abs(rank)));
    if (step == 0) continue;
    probability.resize(probability.size() + step, 0.0);
    for (std::size_t sum = probability.size(); sum-- > 0;)
      probability[sum] = 0.5 * (probability[sum] + (sum >= step ? probability[sum - step] : 0));
  }
  return probability;
}

double exact_rank_p(std::span<const double> ranks, double statistic) {
  const std::vector<double> probability = distribution(ranks);
  const double total = static_cast<double>(probability.size() - 1) / 2;  // of all ranks
  double p = 0;
  for (std::size_t sum = 0; sum < probability.size(); ++sum)
    if (std::abs(static_cast<double>(sum) - total) >= std::abs(statistic) - 1e-9) p += probability[sum];
  return std::min(1.0, p);
}

}  // namespace

std::vector<double> signed_ranks(std::span<const double> differences) {
  std::vector<std::size_t> order(differences.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto size = [&](std::size_t i) { return std::abs(differences[i]); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return size(i) < size(j); });
  std::vector<double> ranks(differences.size(), 0.0);
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && size(order[end]) == size(order[first])) ++end;
    const double rank = 0.5 * static_cast<double>(first + 1 + end);
    for (std::size_t i = first; i < end; ++i)
      if (differences[order[i]] != 0) ranks[order[i]] = std::copysign(rank, differences[order[i]]);
  }
  return ranks;
}

Wilcoxon wilcoxon(std::span<const double> differences) {
  const std::vector<double> ranks = signed_ranks(differences);
  Wilcoxon result;
  result.statistic = std::accumulate(ranks.begin(), ranks.end(), 0.0);
  result.normal = normal_p(ranks, result.statistic);
  result.p = ranks.size() <= kExactUpTo ? exact_rank_p(ranks, result.statistic) : result.normal;
  return result;
}

}  // namespace opal::statistics
