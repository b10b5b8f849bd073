#include <opal/pattern_index.hpp>

#include <algorithm>
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

/// A k-d tree (Bentley 1975) over the invariants of all patterns: an implicit balanced tree in one array, the median
/// of each range at its middle, with a bounding box per node so that whole subtrees are counted or skipped.
struct PatternIndex::Tree {
  int dimensions = 0;
  std::vector<int> order;       ///< pattern numbers in tree order
  std::vector<float> values;    ///< dimensions per pattern, in tree order
  std::vector<Interval> boxes;  ///< dimensions per node, by the node's middle position

  explicit Tree(std::span<const PatternInstance> patterns) {
    if (patterns.empty()) return;
    dimensions = static_cast<int>(patterns.front().invariants.size());
    order.resize(patterns.size());
    std::iota(order.begin(), order.end(), 0);
    boxes.resize(order.size() * dimensions);
    build(patterns, 0, order.size());
    values.reserve(boxes.size());
    for (int number : order)
      for (const Invariant& invariant : patterns[number].invariants)
        values.push_back(static_cast<float>(invariant.value));
  }

  void build(std::span<const PatternInstance> patterns, std::size_t from, std::size_t to) {
    if (from >= to) return;
    const std::size_t middle = from + (to - from) / 2;
    Interval* box = &boxes[middle * dimensions];
    int widest = 0;
    float widest_span = -1;
    for (int d = 0; d < dimensions; ++d) {
      box[d] = {kInfinity, -kInfinity};
      for (std::size_t k = from; k < to; ++k) {
        const auto value = static_cast<float>(patterns[order[k]].invariants[d].value);
        box[d] = {std::min(box[d].low, value), std::max(box[d].high, value)};
      }
      if (box[d].high - box[d].low > widest_span) {
        widest_span = box[d].high - box[d].low;
        widest = d;
      }
    }
    std::nth_element(order.begin() + from, order.begin() + middle, order.begin() + to, [&](int a, int b) {
      return patterns[a].invariants[widest].value < patterns[b].invariants[widest].value;
    });
    build(patterns, from, middle);
    build(patterns, middle + 1, to);
  }

  /// Calls visit(from, to) for ranges that are wholly inside the query, and for single matches; stops when it
  /// returns false.
  template <class Visit>
  bool search(const std::vector<Interval>& query, std::size_t from, std::size_t to, Visit& visit) const {
    if (from >= to) return true;
    const std::size_t middle = from + (to - from) / 2;
    const Interval* box = &boxes[middle * dimensions];
    bool inside = true;
    for (int d = 0; d < dimensions; ++d) {
      if (box[d].low > query[d].high || box[d].high < query[d].low) return true;
      inside = inside && box[d].low >= query[d].low && box[d].high <= query[d].high;
    }
    if (inside) return visit(from, to);
    if (contains(query, middle) && !visit(middle, middle + 1)) return false;
    return search(query, from, middle, visit) && search(query, middle + 1, to, visit);
  }

  bool contains(const std::vector<Interval>& query, std::size_t at) const {
    for (int d = 0; d < dimensions; ++d) {
      const float value = values[at * dimensions + d];
      if (value < query[d].low || value > query[d].high) return false;
    }
    return true;
  }
};

PatternIndex::PatternIndex(std::vector<PatternInstance> patterns)
    : patterns_(std::move(patterns)), tree_(std::make_unique<const Tree>(patterns_)) {}
PatternIndex::~PatternIndex() = default;
PatternIndex::PatternIndex(PatternIndex&&) noexcept = default;

std::span<const PatternInstance> PatternIndex::patterns() const { return patterns_; }

namespace {

std::vector<Interval> query_of(const PatternInstance& observed) {
  std::vector<Interval> query;
  for (const Invariant& invariant : observed.invariants) query.push_back(accepted_by(invariant));
  return query;
}

}  // namespace

std::size_t PatternIndex::count(const PatternInstance& observed, std::size_t limit) const {
  std::size_t found = 0;
  auto add = [&](std::size_t from, std::size_t to) { return (found += to - from) < limit; };
  tree_->search(query_of(observed), 0, tree_->order.size(), add);
  return std::min(found, limit);
}

std::vector<int> PatternIndex::find(const PatternInstance& observed) const {
  std::vector<int> numbers;
  auto add = [&](std::size_t from, std::size_t to) {
    numbers.insert(numbers.end(), tree_->order.begin() + from, tree_->order.begin() + to);
    return true;
  };
  tree_->search(query_of(observed), 0, tree_->order.size(), add);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

}  // namespace opal
