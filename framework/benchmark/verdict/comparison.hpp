#pragma once

#include "benchmark/verdict/results_table.hpp"
#include "benchmark/verdict/verdict.hpp"

namespace opal::statistics {

struct ComparisonOptions {
  std::string baseline;  ///< the arm that every other one is compared with
  std::vector<Metric> metrics;
  double level = 0.05;  ///< chance of a false claim that is put up with, over all arms, metrics and looks
  int bootstrap_samples = 2000;
  std::uint64_t seed = 1;  ///< of the bootstrap
  int look = 1,
      looks = 1;  ///< this is look 1..looks, equally far apart, at an experiment that may be ended at any of them
};

/// One verdict per arm other than the baseline, in order of first appearance; p-values are corrected over all of them.
/// The order of the rows and the names of clusters and queries make no difference. docs/ab_statistics.md says which
/// test and why.
/// @throws opal::Error if there is no baseline, or arms do not have the same (cluster, query, seed), naming one that
/// differs.
std::vector<Verdict> compare(const ResultsTable& table, const ComparisonOptions& options);

}  // namespace opal::statistics
