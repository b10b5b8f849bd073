#pragma once

#include "learning/learned_overlay.hpp"

#include <string>

namespace opal {

/// A list of all proposals for people who keep the building model: CSV (RFC 4180), one a line, most probable first.
/// What came from IFC has its GlobalId in a column of its own, also if the map is a stack of storeys, whose ids begin
/// with one.
std::string deviation_csv(const SemanticMap& map, const Learned& learned);

}  // namespace opal
