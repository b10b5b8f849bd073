#pragma once

#include "benchmark/verdict/results_table.hpp"

#include <span>

namespace opal::statistics {

/// What both arms did with the same query and seed.
struct PairedValue {
  std::string cluster, query;
  std::uint64_t seed = 0;
  double a = 0, b = 0;
};

/// All pairs of one metric.
struct PairedSample {
  std::vector<PairedValue> pairs;  ///< by cluster
  std::size_t left_out = 0;        ///< pairs in which either has no value
};

/// Pairs the rows of two arms, which must have the same (cluster, query, seed). What has not run is worse than all
/// else: 0 of a proportion, infinite for a distance; of a cost nothing is known, so that the pair is left out. Nothing
/// reached is infinite.
/// @throws opal::Error if the arms differ in what they were asked, naming a query, or if a proportion is neither 0
/// nor 1.
PairedSample pair_rows(const ResultsTable& table, const Metric& metric, const std::string& arm_a,
                       const std::string& arm_b);

/// The pairs of each cluster, which stand together in a sample.
std::vector<std::span<const PairedValue>> clusters_of(const PairedSample& sample);

}  // namespace opal::statistics
