#pragma once

#include <cstdint>
#include <span>

namespace opal::statistics {

/// Two-sided p-value of the sum of these numbers among all sums that the same numbers give with other signs (Fisher
/// 1935; of cluster sums: Canay, Romano & Shaikh 2017; the wild cluster bootstrap of Cameron, Gelbach & Miller 2008 of
/// a mean). Exact up to kFlippedExactly numbers other than zero, above by 20,000 draws from a seed. It cannot be below
/// 2^(1 - n).
double sign_flip_test(std::span<const double> sums, std::uint64_t seed = 1);

constexpr std::size_t kFlippedExactly = 30;

}  // namespace opal::statistics
