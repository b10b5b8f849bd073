#pragma once

#include "benchmark/verdict/comparison.hpp"
#include "benchmark/verdict/paired_sample.hpp"

namespace opal::statistics {

/// Compares two arms by one metric: all of the result but what depends on other comparisons (p_corrected) and what
/// follows from that (conclusion.hpp).
/// @param level  1 - coverage of the intervals.
MetricResult compare_metric(const PairedSample& sample, const Metric& metric, double level,
                            const ComparisonOptions& options);

}  // namespace opal::statistics
