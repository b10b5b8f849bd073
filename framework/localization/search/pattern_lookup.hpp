#pragma once

#include "patterns/pattern_index.hpp"

#include <opal/common/id.hpp>
#include <opal/localization/options/localizer_options.hpp>
#include <opal/patterns/pattern_template.hpp>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace opal {

using TemplateNumber = Id<PatternTemplate>;  ///< position among the generator's templates

/// A template, and what the map has of it.
struct MappedTemplate {
  std::string name;
  std::shared_ptr<const PatternTemplate> part;
  PatternIndex index;  ///< members are positions among the mapped features
};

/// An observed pattern that is looked up among mapped ones.
struct PatternLookup {
  TemplateNumber pattern = {};
  PatternInstance observed;
  std::size_t expected = 0;  ///< mapped patterns that the index predicts
};

/// What a pattern leaves open.
enum class PatternKind {
  constrained,       ///< nothing: it fixes the pose
  under_constrained  ///< where it is along its frame's x axis
};

/// A pattern that leaves something free: it may be anywhere along its frame's x axis.
inline bool is_under_constrained(const PatternInstance& pattern) { return pattern.extent_max_m > pattern.extent_min_m; }
inline PatternKind kind_of(const PatternInstance& pattern) {
  return is_under_constrained(pattern) ? PatternKind::under_constrained : PatternKind::constrained;
}

/// What can be told of how much a feature fixes: the length of walls that is seen; nearer points are known better.
double weight_of(const Feature& feature);

/// The observed patterns that are worth looking up: those that the map has, in few places if possible. Parts of others
/// are not among them.
/// @param features  base_link frame; members of the lookups are positions in it.
/// @param kind  that is looked up.
OPAL_EXPORT std::vector<PatternLookup> choose_lookups(std::span<const MappedTemplate> templates,
                                                      std::span<const Feature> features, const SearchOptions& options,
                                                      PatternKind kind);

}  // namespace opal
