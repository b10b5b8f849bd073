#pragma once

#include "benchmark/statistics/cluster_test.hpp"
#include "benchmark/verdict/paired_sample.hpp"

#include <vector>

namespace opal::statistics {

using Pairs = std::span<const PairedValue>;

/// b - a; 0 if both are infinite: neither got there.
double difference(const PairedValue& pair);

std::vector<double> differences(Pairs pairs);

/// What is summed up and tested for a mean of zero: b - a of a proportion, signed ranks of distances (Wilcoxon's,
/// between clusters that of Rosner, Glynn & Lee 2006), ln(b / a) of costs.
std::vector<double> scores(Pairs pairs, Metric::Kind kind);

/// One sum for each cluster, in an order that does not depend on names. @param pairs  by cluster; one score each.
std::vector<ClusterSum> cluster_sums(Pairs pairs, std::span<const double> scores);

/// Each pair by itself, as if all were independent.
std::vector<ClusterSum> single_sums(std::span<const double> scores);

}  // namespace opal::statistics
