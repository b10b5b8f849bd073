#pragma once

#include <opal/common/export.hpp>

#include <sstream>
#include <string>

namespace opal {

/// Writes a whole file, to the last byte, or leaves what was there. @throws WriteError naming the file and the cause.
OPAL_EXPORT void write_text(const std::string& path, const std::string& text);

/// The same with what a function writes to a stream.
template <class Write>
void write_with(const std::string& path, const Write& write) {
  std::ostringstream text;
  write(text);
  write_text(path, text.str());
}

}  // namespace opal
