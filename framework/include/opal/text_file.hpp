#pragma once

#include <opal/semantic_map.hpp>

#include <string>

namespace opal {

/// Writes a whole file, to the last byte. @throws Error naming the file if it cannot be written.
OPAL_EXPORT void write_text(const std::string& path, const std::string& text);

/// Writes a map as a document. @throws Error naming the file if it cannot be written.
OPAL_EXPORT void write_map(const SemanticMap& map, const std::string& path);

}  // namespace opal
