#pragma once

#include <string>
#include <vector>

namespace opal {

/// A symbol that a library defines and others can see.
struct ExportedSymbol {
  std::string name;      ///< as nm -C prints it
  bool is_weak = false;  ///< weak or unique: of an inline function or template, which several libraries may define
};

/// What `nm -DC --defined-only` lists, also for a stripped library. For files without an elf_defect().
std::vector<ExportedSymbol> exported_symbols(const std::string& path);

}  // namespace opal
