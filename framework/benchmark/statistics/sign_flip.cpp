#include "benchmark/statistics/sign_flip.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace opal::statistics {
namespace {

/// Sizes of what is not zero, so that neither order nor a common sign matters.
std::vector<double> sorted_sizes(std::span<const double> sums) {
  std::vector<double> sizes;
  for (const double sum : sums)
    if (sum != 0) sizes.push_back(std::abs(sum));
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

/// All sums of these numbers with either sign, increasing.
std::vector<double> signed_sums(std::span<const double> sizes) {
  std::vector<double> sums{0};
  for (const double size : sizes) {
    std::vector<double> lower = sums;
    for (double& sum : lower) sum -= size;
    for (double& sum : sums) sum += size;
    std::vector<double> merged(2 * sums.size());
    std::merge(lower.begin(), lower.end(), sums.begin(), sums.end(), merged.begin());
    sums = std::move(merged);
  }
  return sums;
}

/// Meets in the middle (Horowitz & Sahni 1974): sums of two halves, of which so many pairs reach the bound.
double exact_p(std::span<const double> sizes, double bound) {
  const std::vector<double> first = signed_sums(sizes.subspan(0, sizes.size() / 2));
  const std::vector<double> second = signed_sums(sizes.subspan(sizes.size() / 2));
  double reaching = 0;
  auto from = second.end();
  for (const double sum : first) {
    while (from != second.begin() && sum + *(from - 1) >= bound) --from;
    reaching += static_cast<double>(second.end() - from);
  }
  return std::min(1.0, 2 * reaching * std::exp2(-static_cast<double>(sizes.size())));
}

/// Their sum with signs from fair bits.
double flipped_sum(std::span<const double> sizes, std::mt19937_64& bits) {
  constexpr std::size_t kBits = 64;
  double sum = 0;
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    word = i % kBits == 0 ? bits() : word >> 1;
    sum += (word & 1) == 1 ? sizes[i] : -sizes[i];
  }
  return sum;
}

double drawn_p(std::span<const double> sizes, double bound, std::uint64_t seed) {
  constexpr int kDraws = 20'000;
  std::mt19937_64 bits(seed);
  int reaching = 0;
  for (int draw = 0; draw < kDraws; ++draw) reaching += std::abs(flipped_sum(sizes, bits)) >= bound;
  return (1.0 + reaching) / (1.0 + kDraws);
}

}  // namespace

double sign_flip_test(std::span<const double> sums, std::uint64_t seed) {
  const std::vector<double> sizes = sorted_sizes(sums);
  const double total = std::accumulate(sizes.begin(), sizes.end(), 0.0);
  const double bound = std::abs(std::accumulate(sums.begin(), sums.end(), 0.0)) - 1e-12 * total;
  if (bound <= 0) return 1;
  return sizes.size() <= kFlippedExactly ? exact_p(sizes, bound) : drawn_p(sizes, bound, seed);
}

}  // namespace opal::statistics
