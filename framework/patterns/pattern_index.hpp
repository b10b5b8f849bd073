#pragma once

#include <opal/patterns/pattern_template.hpp>

#include <memory>
#include <span>
#include <vector>

namespace opal {

/// All instances of a template among some features, found through a spatial index over the features' places. `members`
/// of an instance are positions in `features`, in slot order.
OPAL_EXPORT std::vector<PatternInstance> find_patterns(const PatternTemplate& pattern_template,
                                                       std::span<const Feature> features);

/// The patterns of a map by their invariants: answers "which mapped patterns look like this one" in O(log n + k).
/// Immutable after construction; frame: that of the features (`map`).
class OPAL_EXPORT PatternIndex {
 public:
  explicit PatternIndex(std::vector<PatternInstance> patterns);
  ~PatternIndex();
  PatternIndex(PatternIndex&&) noexcept;

  std::span<const PatternInstance> patterns() const;

  /// How many mapped patterns the observed one may be, counted up to `limit`.
  std::size_t count(const PatternInstance& observed, std::size_t limit) const;
  /// Positions in patterns() of those that the observed one may be, in increasing order.
  std::vector<int> find(const PatternInstance& observed) const;

 private:
  struct Tree;
  std::vector<PatternInstance> patterns_;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace opal
