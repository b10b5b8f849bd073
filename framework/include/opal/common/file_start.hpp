#pragma once

#include <fstream>
#include <string>

namespace opal {

/// The first bytes of a file, at most so many. Empty: the file is empty, or cannot be read.
inline std::string first_bytes(const std::string& path, std::size_t most) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(most, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

/// Removes the byte order mark that some programs write at the start of a text in UTF-8.
inline void erase_byte_order_mark(std::string& text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
}

}  // namespace opal
