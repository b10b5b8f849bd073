#include "patterns/pattern_index.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace opal {
namespace {

/// Different numbers below `end`, sorted. Many of them are sorted sooner by marking them.
std::vector<int> increasing(std::vector<int> numbers, std::size_t end) {
  constexpr std::size_t kBits = 64;
  std::vector<std::uint64_t> marks(numbers.size() * kBits < end ? 0 : end / kBits + 1);
  if (marks.empty()) {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }
  for (int number : numbers) marks[number / kBits] |= std::uint64_t{1} << number % kBits;
  auto next = numbers.begin();
  for (std::size_t k = 0; k < marks.size(); ++k)
    for (std::uint64_t left = marks[k]; left != 0; left &= left - 1)
      *next++ = static_cast<int>(k * kBits) + std::countr_zero(left);
  return numbers;
}

}  // namespace

PatternIndex::PatternIndex(PatternList patterns)
    : tree_(patterns.size(), patterns.dimensions(), patterns.take_values()), patterns_(std::move(patterns)) {}

std::vector<int> PatternIndex::find(const PatternInstance& observed) const {
  return increasing(tree_.find(observed), patterns_.size());
}

}  // namespace opal
