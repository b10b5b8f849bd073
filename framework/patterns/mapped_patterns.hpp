#pragma once

#include "map/view/support_lines.hpp"
#include "patterns/pattern_index.hpp"

#include <opal/common/named.hpp>
#include <opal/map/view/map_view.hpp>
#include <opal/patterns/pattern_template.hpp>

#include <vector>

namespace opal {

/// The map's side of all patterns. The map decides: what its pattern layer names if it has one, else all there are
/// among its features and support lines.
struct MappedPatterns {
  std::vector<MappedFeature> features;
  /// For each template its patterns; members are positions in `features`.
  std::vector<PatternIndex> by_template;
};

/// @throws MapError if the layer contradicts its templates.
MappedPatterns mapped_patterns(const MapView& map, const std::vector<Named<PatternTemplate>>& templates);

}  // namespace opal
