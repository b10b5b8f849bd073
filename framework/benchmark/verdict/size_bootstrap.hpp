#pragma once

#include "benchmark/verdict/comparison.hpp"
#include "benchmark/verdict/paired_sample.hpp"

namespace opal::statistics {

/// Fewer clusters give too few different samples (3 give 10, 6 give 462).
constexpr std::size_t kFewestDrawn = 6;

/// Percentile interval of a difference of shares, a median difference or a ratio of costs (Effect::size), by the
/// cluster bootstrap; with fewer than kFewestDrawn clusters, pairs are drawn within each cluster. It does not depend on
/// names.
Interval size_interval(const PairedSample& sample, Metric::Kind kind, double level, const ComparisonOptions& options);

}  // namespace opal::statistics
