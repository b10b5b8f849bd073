#pragma once

#include "patterns/invariant_tree.hpp"
#include "patterns/pattern_table.hpp"

#include <opal/patterns/pattern_template.hpp>

#include <functional>
#include <span>
#include <vector>

namespace opal {

/// All instances of a template among some features, found through a spatial index over the features' places. `members`
/// of an instance are positions in `features`, in slot order.
OPAL_EXPORT std::vector<PatternInstance> find_patterns(const PatternTemplate& pattern_template,
                                                       std::span<const Feature> features);

/// The same, one after the other: a map may have more than there is room for in memory.
OPAL_EXPORT void each_pattern(const PatternTemplate& pattern_template, std::span<const Feature> features,
                              const std::function<void(PatternInstance&&)>& visit);

/// The patterns of a map by their invariants: answers "which mapped patterns look like this one" in O(log n + k).
/// Immutable after construction; frame: that of the features (`map`).
class OPAL_EXPORT PatternIndex {
 public:
  explicit PatternIndex(PatternList patterns);
  explicit PatternIndex(std::span<const PatternInstance> patterns) : PatternIndex(PatternList(patterns)) {}
  /// Of what was indexed before.
  PatternIndex(PatternTable patterns, InvariantTree tree) : tree_(std::move(tree)), patterns_(std::move(patterns)) {}

  const PatternTable& patterns() const { return patterns_; }
  const InvariantTree& tree() const { return tree_; }

  /// How many mapped patterns the observed one may be, counted up to `limit`.
  std::size_t count(const PatternInstance& observed, std::size_t limit) const { return tree_.count(observed, limit); }
  /// Positions in patterns() of those that the observed one may be, in increasing order.
  std::vector<int> find(const PatternInstance& observed) const;

 private:
  InvariantTree tree_;
  PatternTable patterns_;
};

}  // namespace opal
