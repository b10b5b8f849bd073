#pragma once

#include <span>
#include <vector>

namespace opal::statistics {

/// Ranks of the absolute values, with their signs; equal ones share the mean of their ranks. Zeros take part in the
/// ranking and then weigh nothing (Pratt 1959), so that many ties leave less to be told. Infinite differences rank
/// above all finite ones.
/// @param differences  no NaN.
std::vector<double> signed_ranks(std::span<const double> differences);

/// Two-sided p-values of differences being symmetric about zero (Wilcoxon 1945); differences must be independent.
struct Wilcoxon {
  double statistic = 0;  ///< sum of the signed ranks
  double p = 1;          ///< exact up to kExactUpTo differences, else normal
  double normal = 1;     ///< normal approximation, corrected for ties, without continuity correction
};

/// Above that the exact distribution is not worth its time.
constexpr std::size_t kExactUpTo = 60;

/// 1 if all differences are zero, or none is given.
Wilcoxon wilcoxon(std::span<const double> differences);

}  // namespace opal::statistics
