#pragma once

#include <string>

namespace opal {

/// What a file is that no importer of Opal reads as it is, and what to do about it.
struct ForeignFile {
  std::string what;  ///< ": is a ZIP archive, expected what is in it: unpack it first"; empty: nothing of these
  bool is_placeholder = false;  ///< it stands in the place of another file, whatever its name says
};

/// Known by its first bytes and its ending: a pointer of Git LFS and the web page that shows a file are placeholders;
/// others are archives, pictures without a description, PDF, SVG, and maps of other programs.
ForeignFile what_foreign_file(const std::string& path);

}  // namespace opal
