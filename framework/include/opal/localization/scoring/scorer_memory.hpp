#pragma once

#include <opal/common/export.hpp>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace opal {

/// What one more scan leaves of the evidence that was gathered before it.
/// @param weight  share of a whole, independent piece of evidence that the scan is, in (0, 1].
/// @param memory  what a whole piece leaves, in [0, 1].
constexpr double kept_share(double weight, double memory) { return 1 - weight * (1 - memory); }

/// What a scorer remembers of one hypothesis, or what one scan adds to it. Made, read and changed by that scorer alone;
/// to everybody else it is opaque.
class OPAL_EXPORT ScorerMemory {
 public:
  virtual ~ScorerMemory();
  /// An equal memory that shares nothing that can change.
  virtual std::unique_ptr<ScorerMemory> copy() const = 0;
};

/// What each scorer remembers of one hypothesis, by the scorer's position. A hypothesis carries it: hypotheses that
/// branch share their memories until one of them is about to change (copy on write).
class OPAL_EXPORT ScorerMemories {
 public:
  /// A memory that several hypotheses may hold.
  using Shared = std::shared_ptr<ScorerMemory>;

  ScorerMemories() = default;
  /// One memory per scorer, in the scorers' order; null for one that remembers nothing.
  explicit ScorerMemories(std::vector<Shared> memories) : memories_(std::move(memories)) {}

  /// Nothing has been remembered yet.
  bool empty() const { return memories_.empty(); }
  /// Null for a scorer that remembers nothing.
  const ScorerMemory* of(std::size_t scorer) const {
    return scorer < memories_.size() ? memories_[scorer].get() : nullptr;
  }
  /// The same, to be changed: from here on no other hypothesis shares it.
  ScorerMemory* own(std::size_t scorer);

 private:
  std::vector<Shared> memories_;
};

}  // namespace opal
