#pragma once

#include "localization/search/pattern_lookup.hpp"

#include <opal/localization/scoring/hypothesis.hpp>

#include <vector>

namespace opal {

/// What a candidate or a hypothesis comes from.
enum class Origin {
  pattern,       ///< an observed pattern that looks like a mapped one
  hint,          ///< somebody said that the robot is about here
  other_storey,  ///< a candidate at the same place of another storey
  ride,          ///< a hypothesis whose robot stood in a lift
  branch         ///< a hypothesis that branched in the association tree
};
/// "pattern", "other_storey": as events write it.
OPAL_EXPORT const char* name_of(Origin origin);

/// A pose at which the robot may be; a pattern also says what its features are on the map.
struct Candidate {
  Pose2 T_map_base;
  Origin origin = Origin::pattern;
  TemplateNumber pattern = {};  ///< that proposed it; none: its origin is another one
  std::vector<Association> pairs = {};
};

}  // namespace opal
