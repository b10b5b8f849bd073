#pragma once

#include <opal/common/export.hpp>

#include <string>

namespace opal {

/// Writes a whole file, to the last byte. @throws Error naming the file if it cannot be written.
OPAL_EXPORT void write_text(const std::string& path, const std::string& text);

}  // namespace opal
