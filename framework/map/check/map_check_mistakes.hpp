#pragma once

#include <opal/map/semantic_map.hpp>

#include <string>
#include <vector>

namespace opal {

/// What people get wrong when they write a map by hand, in sentences: degrees for radians, millimetres for metres, a
/// misspelt type, a face drawn backward.
std::vector<std::string> mistakes_of_hand(const SemanticMap& map);

}  // namespace opal
