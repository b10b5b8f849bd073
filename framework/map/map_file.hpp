#pragma once

#include <opal/map/semantic_map.hpp>

#include <string>

namespace opal {

/// Writes a map as a document. @throws Error naming the file if it cannot be written.
OPAL_EXPORT void write_map(const SemanticMap& map, const std::string& path);

}  // namespace opal
