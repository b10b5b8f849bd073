#pragma once

#include "common/prepared/read_only_array.hpp"

#include <opal/patterns/pattern.hpp>

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace opal {

/// A k-d tree (Bentley 1975) over the invariants of patterns. Each node halves its range of patterns at the median
/// of the widest dimension, down to buckets of a few; children of node k are 2 k + 1 and 2 k + 2. Every node has a
/// bounding box, so that whole subtrees are counted or skipped. Patterns without invariants need no tree.
class OPAL_EXPORT InvariantTree {
 public:
  struct Interval {
    float low = -std::numeric_limits<float>::infinity();
    float high = std::numeric_limits<float>::infinity();
  };
  /// All that a tree is, side by side.
  struct Arrays {
    ReadOnlyArray<int> order;       ///< pattern numbers in tree order
    ReadOnlyArray<float> values;    ///< dimensions per pattern, in tree order
    ReadOnlyArray<Interval> boxes;  ///< dimensions per node
  };

  /// @param values  dimensions per pattern.
  InvariantTree(std::size_t patterns, std::size_t dimensions, std::vector<float> values);
  /// @param arrays  as `arrays` of a tree gave them; @see are_sound.
  InvariantTree(std::size_t dimensions, Arrays arrays) : dimensions_(dimensions), arrays_(std::move(arrays)) {}

  /// Whoever asks the tree stays within it.
  static bool are_sound(std::size_t patterns, std::size_t dimensions, const Arrays& arrays);

  std::size_t dimensions() const { return dimensions_; }
  const Arrays& arrays() const { return arrays_; }

  /// How many patterns an observed one may be, counted up to `limit`. With another number of invariants it is none.
  std::size_t count(const PatternInstance& observed, std::size_t limit) const;
  /// Numbers of those, in no order.
  std::vector<int> find(const PatternInstance& observed) const;

 private:
  template <class Visit>
  bool search(std::span<const Interval> query, Visit& visit) const;
  template <class Visit>
  bool search(std::span<const Interval> query, std::size_t node, std::size_t from, std::size_t to, Visit& visit) const;
  bool contains(std::span<const Interval> query, std::size_t at) const;

  std::size_t dimensions_ = 0;
  Arrays arrays_;
};

}  // namespace opal
