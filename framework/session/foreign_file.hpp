#pragma once

#include <string>

namespace opal {

/// What stands in the place of a file, whatever its name says: a pointer of Git LFS, or the web page that shows it.
/// @return ": is a web page, expected ..."; empty: neither.
std::string what_placeholder(const std::string& path);

/// What a file is that no importer of Opal reads as it is, and what to do about it: ": is a ZIP archive, expected what
/// is in it: unpack it first". Known by its first bytes and its ending: archives, pictures without a description, PDF,
/// SVG, and maps of other programs. Empty: nothing of these.
std::string what_foreign_file(const std::string& path);

}  // namespace opal
