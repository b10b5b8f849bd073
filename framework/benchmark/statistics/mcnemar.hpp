#pragma once

#include "benchmark/statistics/interval.hpp"

#include <cstddef>

namespace opal::statistics {

/// Pairs of yes and no, counted: what two arms did with the same queries.
struct PairedCounts {
  std::size_t both = 0, only_a = 0, only_b = 0, neither = 0;

  std::size_t pairs() const { return both + only_a + only_b + neither; }
  std::size_t discordant() const { return only_a + only_b; }
  double share_a() const;
  double share_b() const;
  /// share_b - share_a; 0 without pairs.
  double difference() const;
};

/// Two-sided p-values of "only a" being as likely as "only b" (McNemar 1947); pairs must be independent.
struct McNemar {
  double exact = 1;  ///< binomial
  double mid = 1;    ///< the exact one less half the probability of what was seen (Fagerland, Lydersen & Laake 2013)
};

/// Both are 1 if no pair differs.
McNemar mcnemar(const PairedCounts& counts);

/// Odds of "only b" against "only a": 0, infinite or, if no pair differs, NaN.
double matched_odds_ratio(const PairedCounts& counts);
/// Exact (Clopper & Pearson 1934, of the share of "only b" among the pairs that differ).
Interval matched_odds_ratio_interval(const PairedCounts& counts, double level);

/// Of the difference of two shares, pairs independent: half a pair added to each of the four counts, so that it has a
/// width even where no pair differs (Agresti & Min 2005).
Interval difference_interval(const PairedCounts& counts, double level);

}  // namespace opal::statistics
