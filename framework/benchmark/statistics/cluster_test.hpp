#pragma once

#include "benchmark/statistics/interval.hpp"

#include <cstddef>
#include <span>

namespace opal::statistics {

/// What the pairs of one cluster sum up to. Clusters are independent of each other; pairs within one need not be.
struct ClusterSum {
  double sum = 0;    ///< of scores: differences, signed ranks, logarithms of ratios
  double pairs = 0;  ///< how many scores
};

/// Two-sided p-value of a mean score of zero: Student's t with the cluster-robust variance of Bell & McCaffrey (2002)
/// and their degrees of freedom, which allow for few clusters of unequal size (Cameron, Gelbach & Miller 2008; Imbens &
/// Kolesar 2016). With clusters of equal size it is the t-test of their means. 1 with fewer than two clusters.
double cluster_t_test(std::span<const ClusterSum> clusters);

/// The mean scores that this test does not reject. Infinite with fewer than two clusters.
Interval cluster_t_interval(std::span<const ClusterSum> clusters, double level);

/// Variance of the sum of all scores, clusters independent, about a mean score.
double variance_of_sum(std::span<const ClusterSum> clusters, double mean);

/// No test by signs of so many scores other than zero can give a smaller p-value: all that so many coins carry.
double smallest_p(std::size_t nonzero_scores);

}  // namespace opal::statistics
