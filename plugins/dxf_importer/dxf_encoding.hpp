#pragma once

#include <string>

namespace opal::dxf_importer {

/// A drawing's text as UTF-8: text in UTF-16 is converted, with or without its mark; text that is no UTF-8 is of the
/// code page that $DWGCODEPAGE names (ANSI_1252 if it names none), and "\U+00C4" stands for a character in any release.
/// A byte that the code page does not have becomes '?'.
std::string as_utf8(const std::string& text);

}  // namespace opal::dxf_importer
