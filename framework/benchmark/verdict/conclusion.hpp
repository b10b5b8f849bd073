#pragma once

#include "benchmark/verdict/pair_scores.hpp"
#include "benchmark/verdict/verdict.hpp"

namespace opal::statistics {

/// Sets what p_corrected and the interval say of a metric, and how many more queries would say more.
/// @param tests  among how many the p-value was corrected.
void conclude(MetricResult& result, const PairedSample& sample, double level, std::size_t tests);

/// Which way the scores point; those of distances are ranks, which may tell a difference though the median is 0.
Outcome direction(Pairs pairs, const Metric& metric);

/// The smallest difference that is of interest, the metric's own or that of its kind.
double of_interest(const Metric& metric);

}  // namespace opal::statistics
