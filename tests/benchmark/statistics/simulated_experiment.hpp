#pragma once

#include "benchmark/verdict/comparison.hpp"

/// Results of two arms, "a" and "b", as recorded sites give them: sites differ in how hard they are, queries of a site
/// differ, and what an arm does by chance is partly the same for all windows of a site. Without a planted difference
/// the arms differ by name only.
struct SimulatedExperiment {
  std::vector<std::size_t> cluster_sizes;
  double success = 0.6;     ///< mean over sites
  double site_sigma = 1;    ///< of how hard sites are, in sigmas of a query
  double common = 0.7;      ///< share of a query's variance that both arms share
  double correlated = 0.2;  ///< share of an arm's own variance that all windows of a site share
  double planted = 0;       ///< how much easier everything is for b, in sigmas of a query
  double cost_ratio = 1;    ///< of b to a
};

/// Metrics "success" (0 or 1), "distance_m" (many are 0, infinite without success) and "cpu_ms".
opal::statistics::ResultsTable simulate(const SimulatedExperiment& experiment, std::uint64_t seed);

/// Baseline "a", those three metrics, no bootstrap.
opal::statistics::ComparisonOptions simulated_comparison();

/// The seven recorded places of docs/results.md, by their queries.
inline const std::vector<std::size_t> kRecordedSites{25, 10, 24, 10, 5, 10, 16};
