#pragma once

#include "benchmark/statistics/interval.hpp"

#include <span>

namespace opal::statistics {

/// How many of how many in one cluster.
struct ClusterCount {
  double part = 0, whole = 0;
};

/// Variance of the share of all as the spread between clusters tells it, over that of independent trials (Rao and
/// Scott 1992); at least 1.
double design_effect(std::span<const ClusterCount> clusters);

/// Interval of a share whose trials come in clusters: the exact one (Clopper and Pearson 1934) for as many independent
/// trials as tell as much as these (Korn and Graubard 1998). Without any trial: 0 to 1.
/// @param level  that it misses the truth, both ends together.
Interval share_interval(std::span<const ClusterCount> clusters, double level);

}  // namespace opal::statistics
