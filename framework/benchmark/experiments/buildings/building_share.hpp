#pragma once

#include "benchmark/statistics/share_bound.hpp"
#include "evaluation/calibration.hpp"

#include <span>
#include <vector>

namespace opal::experiments {

/// How many of how many in one building: runs in the same building are not independent.
using Tally = statistics::ClusterCount;

/// Share of all over several buildings, with its 95 % interval.
struct BuildingShare {
  double share = 0;
  Interval within{0, 1};
};

/// Wilson's interval (1927) for as many independent trials as tell as much as these do: their number over the
/// design effect of buildings (Rao and Scott 1992). Without any trial: share 0, interval 0 to 1.
BuildingShare share_over(std::span<const Tally> buildings);

/// A median with its 95 % interval, by drawing whole buildings again (cluster bootstrap, 1000 times, always
/// the same); in a single building, between order statistics of its runs.
struct BuildingMedian {
  double median = 0;  ///< kNever if there is no value, or most are never
  Interval within;
};
BuildingMedian median_over(std::span<const std::vector<double>> buildings);

}  // namespace opal::experiments
