#pragma once

#include "statistics/interval.hpp"

#include <cstddef>
#include <span>

namespace opal::statistics {

/// What the pairs of one cluster sum up to. Clusters are independent of each other; pairs within one need not be.
struct ClusterSum {
  double sum = 0;    ///< of scores: differences, signed ranks, logarithms of ratios
  double pairs = 0;  ///< how many scores
};

/// Two-sided p-value of a mean score of zero: Student's t of the sums, with one degree of freedom less than clusters. Valid though
/// clusters differ in size and spread, as it then only gets conservative (Bakirov & Szekely 2006, Ibragimov & Mueller 2010). It is
/// the cluster-robust test of Cameron, Gelbach & Miller (2008) for a mean. 1 with fewer than two clusters.
double cluster_t_test(std::span<const ClusterSum> clusters);

/// The mean scores that this test does not reject (Fieller 1954): scores less a constant, tested again. Infinite where there are too
/// few clusters, or one holds nearly all pairs.
Interval cluster_t_interval(std::span<const ClusterSum> clusters, double level);

/// Variance of the sum of all scores, clusters independent, about a mean score.
double variance_of_sum(std::span<const ClusterSum> clusters, double mean);

/// No test by signs of so many scores other than zero can give a smaller p-value: all that so many coins carry.
double smallest_p(std::size_t nonzero_scores);

}  // namespace opal::statistics
