#include "benchmark/statistics/cluster_test.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal::statistics {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct MeanScore {
  double value = 0, standard_error = 0, degrees_of_freedom = 0;
};

/// Degrees of freedom for which the variance has the mean and spread of a chi-square if scores were independent (Bell &
/// McCaffrey 2002, of a mean).
double degrees_of_freedom(std::span<const ClusterSum> clusters, double pairs) {
  double squares = 0, leverages = 0, squared_leverages = 0;
  for (const ClusterSum& c : clusters) {
    const double leverage = c.pairs * c.pairs / (pairs - c.pairs);
    squares += c.pairs * c.pairs;
    leverages += leverage;
    squared_leverages += leverage * leverage;
  }
  return pairs * pairs / (squares + leverages * leverages - squared_leverages);
}

/// Residuals of a cluster are blown up by what the mean has taken from them: the larger its share of all pairs, the
/// more.
MeanScore mean_score(std::span<const ClusterSum> clusters) {
  double score = 0, pairs = 0, variance = 0;
  for (const ClusterSum& c : clusters) score += c.sum, pairs += c.pairs;
  const double mean = score / pairs;
  for (const ClusterSum& c : clusters)
    variance += (c.sum - mean * c.pairs) * (c.sum - mean * c.pairs) / (1 - c.pairs / pairs);
  return {mean, std::sqrt(variance) / pairs, degrees_of_freedom(clusters, pairs)};
}

}  // namespace

double cluster_t_test(std::span<const ClusterSum> clusters) {
  if (clusters.size() < 2) return 1;
  const MeanScore mean = mean_score(clusters);
  if (mean.value == 0) return 1;
  if (mean.standard_error <= 1e-10 * std::abs(mean.value)) return 0;
  return 2 *
         cdf(complement(boost::math::students_t(mean.degrees_of_freedom), std::abs(mean.value) / mean.standard_error));
}

Interval cluster_t_interval(std::span<const ClusterSum> clusters, double level) {
  if (clusters.size() < 2) return {-kInfinite, kInfinite};
  const MeanScore mean = mean_score(clusters);
  const double half =
      quantile(complement(boost::math::students_t(mean.degrees_of_freedom), level / 2)) * mean.standard_error;
  return {mean.value - half, mean.value + half};
}

double variance_of_sum(std::span<const ClusterSum> clusters, double mean) {
  if (clusters.size() < 2) return kInfinite;
  double squares = 0;
  for (const ClusterSum& c : clusters) squares += (c.sum - mean * c.pairs) * (c.sum - mean * c.pairs);
  const double n = static_cast<double>(clusters.size());
  return squares * n / (n - 1);
}

double smallest_p(std::size_t nonzero_scores) {
  return std::min(1.0, std::exp2(1 - static_cast<double>(nonzero_scores)));
}

}  // namespace opal::statistics
