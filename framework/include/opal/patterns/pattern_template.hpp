#pragma once

#include <opal/patterns/pattern.hpp>

#include <optional>
#include <span>
#include <vector>

namespace opal {

/// What a template asks the framework to enumerate.
struct PatternShape {
  /// Geometry per slot; its size is the arity. Only features of that geometry are offered for the slot.
  std::vector<GeometryKind> slots;
  /// Members are no farther apart than this [m] (nearest points of the geometries).
  double reach_m = 0;
  /// Features of consecutive slots are no farther apart than this [m]; 0: reach_m. A chain of neighbours is found much
  /// faster than any few features within reach.
  double neighbour_reach_m = 0;
};

/// A geometric relation between a few features, described by numbers that a rigid motion leaves unchanged.
/// The framework enumerates candidate tuples through its spatial index, on the building map and on the local map
/// alike: one code describes both sides, and no template loops over a building. Stateless and thread-safe.
class OPAL_EXPORT PatternTemplate {
 public:
  virtual ~PatternTemplate();

  /// How many features of which shapes a pattern has, and how near they are. It is the same at every call.
  virtual PatternShape shape() const = 0;

  /// @param features  one feature per slot, all different, in one frame, any frame; only of types that the template
  ///                  consumes. Every selection that fits the slots is offered once per order; a template accepts
  ///                  exactly one order of its canonical choice.
  /// @return the instance; nullopt if these form none. All instances of a template have the same number of
  ///         invariants, with the same comparisons.
  virtual std::optional<PatternInstance> match(std::span<const Feature* const> features) const = 0;
};

}  // namespace opal
