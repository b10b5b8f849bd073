#pragma once

#include <opal/map/semantic_map.hpp>

#include <vector>

namespace opal {

/// The faces of walls and other straight things that some sensor perceives, in the map's order; frame `map`.
OPAL_EXPORT std::vector<Segment> perceivable_faces(const SemanticMap& map);

}  // namespace opal
