#include "patterns/pattern_index.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>

namespace opal {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Interval {
  float low = -kInfinity;
  float high = kInfinity;
};

Interval accepted_by(const Invariant& observed) {
  const auto value = static_cast<float>(observed.value), slack = static_cast<float>(observed.tolerance);
  switch (observed.comparison) {
    case Comparison::equal: return {value - slack, value + slack};
    case Comparison::mapped_at_most: return {-kInfinity, value + slack};
    case Comparison::mapped_at_least: return {value - slack, kInfinity};
  }
  return {};
}

}  // namespace

/// A k-d tree (Bentley 1975) over the invariants of all patterns. Each node halves its range of patterns at the median
/// of the widest dimension, down to buckets of a few; children of node k are 2 k + 1 and 2 k + 2. Every node has a
/// bounding box, so that whole subtrees are counted or skipped. Patterns without invariants need no tree.
struct PatternIndex::Tree {
  static constexpr std::size_t kBucket = 16;

  std::size_t dimensions = 0;
  std::vector<int> order;       ///< pattern numbers in tree order
  std::vector<float> values;    ///< dimensions per pattern, in tree order
  std::vector<Interval> boxes;  ///< dimensions per node

  explicit Tree(PatternTable& patterns) {
    if (patterns.size() == 0) return;
    dimensions = patterns.dimensions();
    order.resize(patterns.size());
    std::iota(order.begin(), order.end(), 0);
    values = patterns.take_values();
    if (dimensions == 0) return;  // all are alike
    Scratch scratch;
    build(scratch, 0, 0, order.size());
  }

  /// What is needed to put a range into another order.
  struct Scratch {
    std::vector<std::pair<float, std::size_t>> keys;  ///< value and position
    std::vector<int> order;
    std::vector<float> values;
  };

  void build(Scratch& scratch, std::size_t node, std::size_t from, std::size_t to) {
    if (boxes.size() < (node + 1) * dimensions) boxes.resize((node + 1) * dimensions);
    const std::size_t widest = enclose(node, from, to);
    if (to - from <= kBucket) return;
    const std::size_t middle = from + (to - from) / 2;
    halve(scratch, from, middle, to, widest);
    build(scratch, 2 * node + 1, from, middle);
    build(scratch, 2 * node + 2, middle, to);
  }

  /// Puts the lower values of a dimension before the middle. Patterns are moved with their numbers: in a large map,
  /// what is not side by side is far away.
  void halve(Scratch& scratch, std::size_t from, std::size_t middle, std::size_t to, std::size_t dimension) {
    scratch.keys.clear();
    for (std::size_t k = from; k < to; ++k) scratch.keys.emplace_back(values[k * dimensions + dimension], k);
    std::nth_element(scratch.keys.begin(), scratch.keys.begin() + static_cast<std::ptrdiff_t>(middle - from),
                     scratch.keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    scratch.order.clear();
    scratch.values.clear();
    for (const auto& [value, k] : scratch.keys) {
      scratch.order.push_back(order[k]);
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(k * dimensions);
      scratch.values.insert(scratch.values.end(), row, row + static_cast<std::ptrdiff_t>(dimensions));
    }
    std::copy(scratch.order.begin(), scratch.order.end(), order.begin() + static_cast<std::ptrdiff_t>(from));
    std::copy(scratch.values.begin(), scratch.values.end(),
              values.begin() + static_cast<std::ptrdiff_t>(from * dimensions));
  }

  /// Sets the node's box. @return its widest dimension.
  std::size_t enclose(std::size_t node, std::size_t from, std::size_t to) {
    Interval* box = &boxes[node * dimensions];
    std::fill(box, box + dimensions, Interval{kInfinity, -kInfinity});
    for (std::size_t k = from; k < to; ++k)
      for (std::size_t d = 0; d < dimensions; ++d) {
        const float value = values[k * dimensions + d];
        box[d] = {std::min(box[d].low, value), std::max(box[d].high, value)};
      }
    const auto narrower = [](const Interval& a, const Interval& b) { return a.high - a.low < b.high - b.low; };
    return static_cast<std::size_t>(std::max_element(box, box + dimensions, narrower) - box);
  }

  /// Calls visit(from, to) for ranges that are wholly inside the query, and for single matches; stops when it
  /// returns false.
  template <class Visit>
  bool search(const std::vector<Interval>& query, Visit& visit) const {
    if (order.empty()) return true;
    return dimensions == 0 ? visit(0, order.size()) : search(query, 0, 0, order.size(), visit);
  }

  template <class Visit>
  bool search(const std::vector<Interval>& query, std::size_t node, std::size_t from, std::size_t to,
              Visit& visit) const {
    const Interval* box = &boxes[node * dimensions];
    bool inside = true;
    for (std::size_t d = 0; d < dimensions; ++d) {
      if (box[d].low > query[d].high || box[d].high < query[d].low) return true;
      inside = inside && box[d].low >= query[d].low && box[d].high <= query[d].high;
    }
    if (inside) return visit(from, to);
    if (to - from <= kBucket) {
      for (std::size_t k = from; k < to; ++k)
        if (contains(query, k) && !visit(k, k + 1)) return false;
      return true;
    }
    const std::size_t middle = from + (to - from) / 2;
    return search(query, 2 * node + 1, from, middle, visit) && search(query, 2 * node + 2, middle, to, visit);
  }

  /// Compares all dimensions: which of them rules a pattern out is nothing that a processor could guess.
  bool contains(const std::vector<Interval>& query, std::size_t at) const {
    bool inside = true;
    for (std::size_t d = 0; d < dimensions; ++d) {
      const float value = values[at * dimensions + d];
      inside &= !(value < query[d].low);
      inside &= !(value > query[d].high);
    }
    return inside;
  }
};

PatternIndex::PatternIndex(PatternTable patterns) : patterns_(std::move(patterns)) {
  tree_ = std::make_unique<const Tree>(patterns_);
  patterns_.shrink_to_fit();
}
PatternIndex::~PatternIndex() = default;
PatternIndex::PatternIndex(PatternIndex&&) noexcept = default;

namespace {

std::vector<Interval> query_of(const PatternInstance& observed) {
  std::vector<Interval> query;
  for (const Invariant& invariant : observed.invariants) query.push_back(accepted_by(invariant));
  return query;
}

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

std::size_t PatternIndex::count(const PatternInstance& observed, std::size_t limit) const {
  std::size_t found = 0;
  auto add = [&](std::size_t from, std::size_t to) { return (found += to - from) < limit; };
  tree_->search(query_of(observed), add);
  return std::min(found, limit);
}

std::vector<int> PatternIndex::find(const PatternInstance& observed) const {
  std::vector<int> numbers;
  auto add = [&](std::size_t from, std::size_t to) {
    numbers.insert(numbers.end(), tree_->order.begin() + from, tree_->order.begin() + to);
    return true;
  };
  tree_->search(query_of(observed), add);
  return increasing(std::move(numbers), patterns_.size());
}

}  // namespace opal
