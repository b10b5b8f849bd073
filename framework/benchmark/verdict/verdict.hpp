#pragma once

#include "benchmark/statistics/interval.hpp"
#include "benchmark/statistics/mcnemar.hpp"
#include "benchmark/verdict/results_table.hpp"

namespace opal::statistics {

/// What is known of an arm beside the baseline. equal: a difference that is of interest is not to be expected.
/// open: neither that nor a difference can be told from so little.
enum class Outcome { better, worse, equal, open };

/// How far arm b is from arm a, the baseline.
struct Effect {
  double a = 0, b = 0;  ///< share of a proportion; median of a distance (infinite: most never got there) or a cost
  double size = 0;      ///< difference of the shares; median of the paired differences; ratio of costs (geometric mean)
  Interval interval;    ///< of the size, at the level of this look
};

/// One cluster by itself, its queries taken as independent.
struct ClusterResult {
  std::string cluster;
  std::size_t pairs = 0, better = 0, worse = 0;  ///< pairs in which b is
  Effect effect;
  double p = 1, p_corrected = 1;  ///< Holm over the clusters
  Outcome outcome = Outcome::open;
};

/// One metric, all clusters.
struct MetricResult {
  Metric metric;
  std::size_t pairs = 0, left_out = 0, better = 0, worse = 0;
  std::size_t never_a = 0, never_b = 0;  ///< distances that were never reached
  Effect effect;
  /// Whether clusters, not pairs, are taken as independent, so that it holds for other clusters, too; there must be
  /// kFewestClusters.
  bool between_clusters = false;
  double p = 1;            ///< that decides: between clusters if there are enough, else p_pairs
  double p_corrected = 1;  ///< Holm over arms and metrics
  double p_pairs = 1;      ///< McNemar (mid-p), Wilcoxon; of a cost, t of the logarithms: pairs taken as independent
  double p_sign_flip = 1;  ///< of the cluster sums, exact; for comparison
  Interval bootstrap;      ///< of the size: percentiles of the cluster bootstrap, for comparison
  PairedCounts counts;     ///< of a proportion
  double odds_ratio = 1;   ///< of a proportion: pairs that only b gets right for each that only a does
  Interval odds_ratio_interval;
  double design_effect = 1;  ///< variance by clusters over variance by pairs
  double told =
      0;  ///< the difference that the next number is for: the one seen, or the one of interest if that is larger
  double more_queries =
      0;  ///< that would tell it with power 0.8, from as many more clusters of the same kind; may be infinite
  Outcome outcome = Outcome::open;
  std::vector<ClusterResult> clusters;  ///< by name
};

/// From so many on, the test between clusters keeps its level; two often sum up to the same by chance
/// (docs/ab_statistics.md).
constexpr std::size_t kFewestClusters = 3;

/// What an experiment says of one arm beside the baseline.
struct Verdict {
  std::string arm, baseline;
  std::size_t queries = 0, clusters = 0;  ///< of each arm, seeds counted
  std::size_t failures = 0, failures_baseline = 0;
  int look = 1, looks = 1;
  double level = 0.05;  ///< of this look: what p_corrected must not exceed, and 1 - coverage of the intervals
  std::vector<MetricResult> metrics;
  std::string sentence;            ///< what the numbers carry, in words
  std::vector<std::string> notes;  ///< what one must know beside it
};

}  // namespace opal::statistics
