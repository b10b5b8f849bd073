#pragma once

#include <string>

namespace opal {

/// Text as content of an element or as the value of an attribute in double quotes (HTML, 13.1.2.3); control characters
/// become spaces, but for tabs and ends of lines where those are wanted.
std::string html_text(const std::string& text, bool keep_lines = false);

}  // namespace opal
