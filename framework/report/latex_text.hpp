#pragma once

#include <string>

namespace opal {

/// Text as LaTeX sets it: what LaTeX takes for more than text is escaped, control characters become spaces, "∞" and a
/// minus before a number are the symbols. Other characters stay as they are, in UTF-8.
std::string latex_text(const std::string& text);

}  // namespace opal
