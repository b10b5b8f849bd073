#include "statistics/cluster_test.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal::statistics {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Sums over clusters: of scores and pairs, and of squares and products about their means, scaled so that those are
/// variances and covariance of the totals.
struct Totals {
  double clusters = 0, score = 0, pairs = 0;
  double score_score = 0, score_pairs = 0, pairs_pairs = 0;
};

Totals totals(std::span<const ClusterSum> clusters) {
  Totals t;
  t.clusters = static_cast<double>(clusters.size());
  for (const ClusterSum& c : clusters) t.score += c.sum, t.pairs += c.pairs;
  const double scale = t.clusters / (t.clusters - 1);
  for (const ClusterSum& c : clusters) {
    const double score = c.sum - t.score / t.clusters, pairs = c.pairs - t.pairs / t.clusters;
    t.score_score += scale * score * score;
    t.score_pairs += scale * score * pairs;
    t.pairs_pairs += scale * pairs * pairs;
  }
  return t;
}

}  // namespace

double cluster_t_test(std::span<const ClusterSum> clusters) {
  if (clusters.size() < 2) return 1;
  const Totals t = totals(clusters);
  if (t.score == 0) return 1;
  if (t.score_score <= 1e-20 * t.score * t.score) return 0;
  return 2 * cdf(complement(boost::math::students_t(t.clusters - 1), std::abs(t.score) / std::sqrt(t.score_score)));
}

Interval cluster_t_interval(std::span<const ClusterSum> clusters, double level) {
  if (clusters.size() < 2) return {-kInfinite, kInfinite};
  const Totals t = totals(clusters);
  const double quantile_t = quantile(complement(boost::math::students_t(t.clusters - 1), level / 2));
  const double q2 = quantile_t * quantile_t;
  // (score - m pairs)^2 <= q^2 var(score - m pairs), a quadratic in the mean score m.
  const double a = t.pairs * t.pairs - q2 * t.pairs_pairs;
  const double b = t.score * t.pairs - q2 * t.score_pairs;
  const double c = t.score * t.score - q2 * t.score_score;
  if (a <= 0) return {-kInfinite, kInfinite};
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  return {(b - root) / a, (b + root) / a};
}

double variance_of_sum(std::span<const ClusterSum> clusters, double mean) {
  if (clusters.size() < 2) return kInfinite;
  double squares = 0;
  for (const ClusterSum& c : clusters) squares += (c.sum - mean * c.pairs) * (c.sum - mean * c.pairs);
  const double n = static_cast<double>(clusters.size());
  return squares * n / (n - 1);
}

double smallest_p(std::size_t nonzero_scores) { return std::min(1.0, std::exp2(1 - static_cast<double>(nonzero_scores))); }

}  // namespace opal::statistics
