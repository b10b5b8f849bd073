#include "benchmark/verdict/pair_scores.hpp"

#include "benchmark/statistics/wilcoxon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace opal::statistics {
namespace {

/// By size, so that neither names nor a common sign changes how it is rounded.
double sorted_sum(std::vector<double> values) {
  std::sort(values.begin(), values.end(),
            [](double x, double y) { return std::abs(x) < std::abs(y) || (std::abs(x) == std::abs(y) && x < y); });
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::vector<ClusterSum> sorted(std::vector<ClusterSum> sums) {
  std::sort(sums.begin(), sums.end(), [](const ClusterSum& x, const ClusterSum& y) {
    return std::make_pair(x.pairs, std::abs(x.sum)) < std::make_pair(y.pairs, std::abs(y.sum)) ||
           (x.pairs == y.pairs && std::abs(x.sum) == std::abs(y.sum) && x.sum < y.sum);
  });
  return sums;
}

}  // namespace

double difference(const PairedValue& pair) { return pair.a == pair.b ? 0 : pair.b - pair.a; }

std::vector<double> differences(Pairs pairs) {
  std::vector<double> all;
  for (const PairedValue& pair : pairs) all.push_back(difference(pair));
  return all;
}

std::vector<double> scores(Pairs pairs, Metric::Kind kind) {
  if (kind == Metric::Kind::distance_until) return signed_ranks(differences(pairs));
  if (kind == Metric::Kind::proportion) return differences(pairs);
  std::vector<double> all;
  for (const PairedValue& pair : pairs) all.push_back(std::log(pair.b) - std::log(pair.a));
  return all;
}

std::vector<ClusterSum> cluster_sums(Pairs pairs, std::span<const double> scores) {
  std::vector<ClusterSum> sums;
  for (std::size_t first = 0, end = 0; first < pairs.size(); first = end) {
    while (end < pairs.size() && pairs[end].cluster == pairs[first].cluster) ++end;
    sums.push_back({sorted_sum({scores.begin() + static_cast<std::ptrdiff_t>(first),
                                scores.begin() + static_cast<std::ptrdiff_t>(end)}),
                    static_cast<double>(end - first)});
  }
  return sorted(std::move(sums));
}

std::vector<ClusterSum> single_sums(std::span<const double> scores) {
  std::vector<ClusterSum> sums;
  for (const double score : scores) sums.push_back({score, 1});
  return sorted(std::move(sums));
}

}  // namespace opal::statistics
