#include "patterns/invariant_tree.hpp"

#include <algorithm>
#include <numeric>

namespace opal {
namespace {

using Interval = InvariantTree::Interval;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kBucket = 16;

Interval accepted_by(const Invariant& observed) {
  const auto value = static_cast<float>(observed.value), slack = static_cast<float>(observed.tolerance);
  switch (observed.comparison) {
    case Comparison::equal: return {value - slack, value + slack};
    case Comparison::mapped_at_most: return {-kInfinity, value + slack};
    case Comparison::mapped_at_least: return {value - slack, kInfinity};
  }
  return {};
}

std::vector<Interval> query_of(const PatternInstance& observed) {
  std::vector<Interval> query;
  for (const Invariant& invariant : observed.invariants) query.push_back(accepted_by(invariant));
  return query;
}

std::size_t middle_of(std::size_t from, std::size_t to) { return from + (to - from) / 2; }

/// How many boxes the subtree of a node needs, counted from the root's: children stand behind their parents.
std::size_t end_of_nodes(std::size_t node, std::size_t patterns) {
  if (patterns <= kBucket) return node + 1;
  return std::max(end_of_nodes(2 * node + 1, patterns / 2), end_of_nodes(2 * node + 2, patterns - patterns / 2));
}

class TreeBuilder {
 public:
  TreeBuilder(std::size_t patterns, std::size_t dimensions, std::vector<float> values)
      : dimensions_(dimensions), order_(patterns), values_(std::move(values)) {
    std::iota(order_.begin(), order_.end(), 0);
    if (patterns == 0 || dimensions == 0) return;  // all are alike
    boxes_.resize(end_of_nodes(0, patterns) * dimensions);
    build(0, 0, patterns);
  }

  InvariantTree::Arrays take() {
    return {ReadOnlyArray<int>(std::move(order_)), ReadOnlyArray<float>(std::move(values_)),
            ReadOnlyArray<Interval>(std::move(boxes_))};
  }

 private:
  void build(std::size_t node, std::size_t from, std::size_t to) {
    const std::size_t widest = enclose(node, from, to);
    if (to - from <= kBucket) return;
    const std::size_t middle = middle_of(from, to);
    halve(from, middle, to, widest);
    build(2 * node + 1, from, middle);
    build(2 * node + 2, middle, to);
  }

  /// Puts the lower values of a dimension before the middle. Patterns are moved with their numbers: in a large map,
  /// what is not side by side is far away.
  void halve(std::size_t from, std::size_t middle, std::size_t to, std::size_t dimension) {
    scratch_.keys.clear();
    for (std::size_t k = from; k < to; ++k) scratch_.keys.emplace_back(values_[k * dimensions_ + dimension], k);
    std::nth_element(scratch_.keys.begin(), scratch_.keys.begin() + static_cast<std::ptrdiff_t>(middle - from),
                     scratch_.keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    scratch_.order.clear();
    scratch_.values.clear();
    for (const auto& [value, k] : scratch_.keys) {
      scratch_.order.push_back(order_[k]);
      const auto row = values_.begin() + static_cast<std::ptrdiff_t>(k * dimensions_);
      scratch_.values.insert(scratch_.values.end(), row, row + static_cast<std::ptrdiff_t>(dimensions_));
    }
    std::ranges::copy(scratch_.order, order_.begin() + static_cast<std::ptrdiff_t>(from));
    std::ranges::copy(scratch_.values, values_.begin() + static_cast<std::ptrdiff_t>(from * dimensions_));
  }

  /// Sets the node's box. @return its widest dimension.
  std::size_t enclose(std::size_t node, std::size_t from, std::size_t to) {
    Interval* box = &boxes_[node * dimensions_];
    std::fill(box, box + dimensions_, Interval{kInfinity, -kInfinity});
    for (std::size_t k = from; k < to; ++k)
      for (std::size_t d = 0; d < dimensions_; ++d) {
        const float value = values_[k * dimensions_ + d];
        box[d] = {std::min(box[d].low, value), std::max(box[d].high, value)};
      }
    const auto narrower = [](const Interval& a, const Interval& b) { return a.high - a.low < b.high - b.low; };
    return static_cast<std::size_t>(std::max_element(box, box + dimensions_, narrower) - box);
  }

  /// What is needed to put a range into another order.
  struct Scratch {
    std::vector<std::pair<float, std::size_t>> keys;  ///< value and position
    std::vector<int> order;
    std::vector<float> values;
  };

  std::size_t dimensions_;
  std::vector<int> order_;
  std::vector<float> values_;
  std::vector<Interval> boxes_;
  Scratch scratch_;
};

}  // namespace

InvariantTree::InvariantTree(std::size_t patterns, std::size_t dimensions, std::vector<float> values)
    : dimensions_(dimensions), arrays_(TreeBuilder(patterns, dimensions, std::move(values)).take()) {}

bool InvariantTree::are_sound(std::size_t patterns, std::size_t dimensions, const Arrays& arrays) {
  const auto order = arrays.order.values();
  const bool is_needed = patterns > 0 && dimensions > 0;
  return order.size() == patterns && arrays.values.size() == patterns * dimensions &&
         arrays.boxes.size() == (is_needed ? end_of_nodes(0, patterns) * dimensions : 0) &&
         std::ranges::all_of(
             order, [patterns](int number) { return number >= 0 && static_cast<std::size_t>(number) < patterns; });
}

/// Calls visit(from, to) for ranges that are wholly inside the query, and for single matches; stops when it
/// returns false.
template <class Visit>
bool InvariantTree::search(std::span<const Interval> query, Visit& visit) const {
  const std::size_t patterns = arrays_.order.size();
  if (patterns == 0) return true;
  return dimensions_ == 0 ? visit(0, patterns) : search(query, 0, 0, patterns, visit);
}

template <class Visit>
bool InvariantTree::search(std::span<const Interval> query, std::size_t node, std::size_t from, std::size_t to,
                           Visit& visit) const {
  const Interval* box = &arrays_.boxes[node * dimensions_];
  bool inside = true;
  for (std::size_t d = 0; d < dimensions_; ++d) {
    if (box[d].low > query[d].high || box[d].high < query[d].low) return true;
    inside = inside && box[d].low >= query[d].low && box[d].high <= query[d].high;
  }
  if (inside) return visit(from, to);
  if (to - from <= kBucket) {
    for (std::size_t k = from; k < to; ++k)
      if (contains(query, k) && !visit(k, k + 1)) return false;
    return true;
  }
  const std::size_t middle = middle_of(from, to);
  return search(query, 2 * node + 1, from, middle, visit) && search(query, 2 * node + 2, middle, to, visit);
}

/// Compares all dimensions: which of them rules a pattern out is nothing that a processor could guess.
bool InvariantTree::contains(std::span<const Interval> query, std::size_t at) const {
  bool inside = true;
  for (std::size_t d = 0; d < dimensions_; ++d) {
    const float value = arrays_.values[at * dimensions_ + d];
    inside &= !(value < query[d].low);
    inside &= !(value > query[d].high);
  }
  return inside;
}

std::size_t InvariantTree::count(const PatternInstance& observed, std::size_t limit) const {
  if (observed.invariants.size() != dimensions_) return 0;
  std::size_t found = 0;
  auto add = [&](std::size_t from, std::size_t to) { return (found += to - from) < limit; };
  search(query_of(observed), add);
  return std::min(found, limit);
}

std::vector<int> InvariantTree::find(const PatternInstance& observed) const {
  std::vector<int> numbers;
  if (observed.invariants.size() != dimensions_) return numbers;
  const auto order = arrays_.order.values();
  auto add = [&](std::size_t from, std::size_t to) {
    numbers.insert(numbers.end(), order.begin() + static_cast<std::ptrdiff_t>(from),
                   order.begin() + static_cast<std::ptrdiff_t>(to));
    return true;
  };
  search(query_of(observed), add);
  return numbers;
}

}  // namespace opal
