#pragma once

#include <string>

namespace opal {

/// Whether a file is a whole 64-bit ELF shared library for this byte order. The dynamic loader maps segments
/// without looking at the file's length, so that a truncated library kills the process (SIGBUS) instead of
/// failing to load.
/// @return what is wrong with the file, as the end of a sentence about it; empty if nothing.
std::string elf_defect(const std::string& path);

}  // namespace opal
