#pragma once

#include "statistics/comparison.hpp"
#include "statistics/paired_sample.hpp"

namespace opal::statistics {

/// Compares two arms by one metric: all of the result but what depends on other comparisons (p_corrected, outcome, more_queries).
/// @param level  1 - coverage of the intervals.
MetricResult compare_metric(const PairedSample& sample, const Metric& metric, double level, const ComparisonOptions& options);

/// What p_corrected and the interval say, and how many more queries would say more.
/// @param tests  among how many the p-value was corrected.
void conclude(MetricResult& result, const PairedSample& sample, double level, std::size_t tests);

/// The smallest difference that is of interest, the metric's own or that of its kind.
double of_interest(const Metric& metric);

}  // namespace opal::statistics
