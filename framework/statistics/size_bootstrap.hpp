#pragma once

#include "statistics/comparison.hpp"
#include "statistics/paired_sample.hpp"

namespace opal::statistics {

/// Percentile interval of a difference of shares, a median difference or a ratio of costs (Effect::size), by the cluster bootstrap;
/// with fewer than kFewestClusters, pairs are drawn within each cluster. It does not depend on names.
Interval size_interval(const PairedSample& sample, Metric::Kind kind, double level, const ComparisonOptions& options);

}  // namespace opal::statistics
