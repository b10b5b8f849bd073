#pragma once

#include <cstddef>
#include <string>

/// How often a part is in a text.
inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// A page without the script that draws its plots.
inline std::string without_drawing(const std::string& page) { return page.substr(0, page.rfind("<script nonce=")); }
