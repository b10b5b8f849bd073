#include "benchmark/statistics/mcnemar.hpp"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace opal::statistics {
namespace {

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

double odds(double probability) {
  return probability >= 1 ? std::numeric_limits<double>::infinity() : probability / (1 - probability);
}

}  // namespace

double PairedCounts::share_a() const { return share(both + only_a, pairs()); }
double PairedCounts::share_b() const { return share(both + only_b, pairs()); }
double PairedCounts::difference() const { return share(only_b, pairs()) - share(only_a, pairs()); }

McNemar mcnemar(const PairedCounts& counts) {
  if (counts.only_a == counts.only_b) return {};
  const double n = static_cast<double>(counts.discordant());
  const double fewer = static_cast<double>(std::min(counts.only_a, counts.only_b));
  const boost::math::binomial even(n, 0.5);
  const double exact = 2 * cdf(even, fewer);
  return {std::min(1.0, exact), exact - pdf(even, fewer)};
}

double matched_odds_ratio(const PairedCounts& counts) {
  if (counts.discordant() == 0) return std::numeric_limits<double>::quiet_NaN();
  return odds(share(counts.only_b, counts.discordant()));
}

Interval matched_odds_ratio_interval(const PairedCounts& counts, double level) {
  const double a = static_cast<double>(counts.only_a), b = static_cast<double>(counts.only_b);
  using boost::math::beta_distribution;
  const double low = b == 0 ? 0 : quantile(beta_distribution<>(b, a + 1), level / 2);
  const double high = a == 0 ? 1 : quantile(complement(beta_distribution<>(b + 1, a), level / 2));
  return {odds(low), odds(high)};
}

Interval difference_interval(const PairedCounts& counts, double level) {
  const double n = static_cast<double>(counts.pairs()) + 2;
  const double a = static_cast<double>(counts.only_a) + 0.5, b = static_cast<double>(counts.only_b) + 0.5;
  const double z = quantile(complement(boost::math::normal(), level / 2));
  const double half = z * std::sqrt(a + b - (b - a) * (b - a) / n) / n;
  return {std::max(-1.0, (b - a) / n - half), std::min(1.0, (b - a) / n + half)};
}

}  // namespace opal::statistics
