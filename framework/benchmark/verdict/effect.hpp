#pragma once

#include "benchmark/verdict/pair_scores.hpp"
#include "benchmark/verdict/verdict.hpp"

namespace opal::statistics {

/// What is taken as independent.
enum class Independent { clusters, pairs };

/// Sizes with intervals. A difference of shares and a ratio of costs: what the cluster-robust t-test does not reject;
/// the former at least as wide as difference_interval() while so few pairs differ that nothing could be told. A median
/// difference: what the same test of the signs about it does not reject.
Effect effect_of(Pairs pairs, Metric::Kind kind, Independent independent, double level);

/// Two-sided p-value of no difference.
double p_of(Pairs pairs, Metric::Kind kind, Independent independent);

PairedCounts counts_of(Pairs pairs);

}  // namespace opal::statistics
