#pragma once

#include <opal/patterns/pattern_template.hpp>
#include <opal/plugin/registrar.hpp>

#include <string>
#include <vector>

namespace opal::testing {

/// What a template is tried on, besides degenerate and not-a-number features.
struct PatternTrial {
  /// Selections that must form instances, in any order of their features; empty: random selections are tried,
  /// and some of them must form one.
  std::vector<std::vector<Feature>> selections;
  int random_selections = 3000;  ///< tried if `selections` is empty
  double tolerance = 1e-6;       ///< of invariants and frames [m, rad], relative to their size
};

/// What every template promises (pattern_template.hpp): invariants that no rigid motion changes, with the
/// same number and comparisons in every instance; a frame that moves with the features; of the orders of a
/// selection exactly one accepted; nothing thrown and nothing infinite for degenerate features; the same
/// answer twice and from two threads.
/// @return violations, one sentence each; empty for a good citizen.
OPAL_EXPORT std::vector<std::string> pattern_violations(const PatternTemplate& pattern, const TypeInfo& type,
                                                        const PatternTrial& trial = {});

}  // namespace opal::testing
