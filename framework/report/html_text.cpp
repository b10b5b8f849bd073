#include "report/html_text.hpp"

namespace opal {

std::string html_text(const std::string& text, bool keep_lines) {
  std::string escaped;
  for (const char c : text) {
    const bool line = c == '\n' || c == '\t';
    if (c == '&')
      escaped += "&amp;";
    else if (c == '"')
      escaped += "&quot;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else
      escaped += static_cast<unsigned char>(c) < 0x20 && !(line && keep_lines) ? ' ' : c;
  }
  return escaped;
}

}  // namespace opal
