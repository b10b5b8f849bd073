#include "plugin/elf_symbols.hpp"

#include "plugin/elf_file.hpp"

#include <cxxabi.h>

#include <cstdlib>

namespace opal {
namespace {

std::string demangled(const std::string& name) {
  int status = 0;
  char* text = abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status);
  const std::string plain = status == 0 ? text : name;
  std::free(text);
  return plain;
}

bool is_exported(const Elf64_Sym& symbol) {
  const unsigned visibility = ELF64_ST_VISIBILITY(symbol.st_other);
  return symbol.st_shndx != SHN_UNDEF && ELF64_ST_BIND(symbol.st_info) != STB_LOCAL &&
         (visibility == STV_DEFAULT || visibility == STV_PROTECTED);
}

std::vector<ExportedSymbol> symbols_in(ElfFile& file, const Elf64_Shdr& table, const Elf64_Shdr& text) {
  std::vector<ExportedSymbol> exported;
  std::vector<char> names = file.read<char>(text.sh_offset, text.sh_size);
  names.push_back('\0');
  for (const Elf64_Sym& symbol : file.read<Elf64_Sym>(table.sh_offset, table.sh_size / sizeof(Elf64_Sym))) {
    if (!is_exported(symbol) || symbol.st_name >= names.size()) continue;
    exported.push_back({demangled(names.data() + symbol.st_name), ELF64_ST_BIND(symbol.st_info) != STB_GLOBAL});
  }
  return exported;
}

}  // namespace

std::vector<ExportedSymbol> exported_symbols(const std::string& path) {
  ElfFile file(path);
  const auto header = file.read<Elf64_Ehdr>(0, 1);
  if (header.empty()) return {};
  const auto sections = file.read<Elf64_Shdr>(header.front().e_shoff, header.front().e_shnum);
  for (const Elf64_Shdr& section : sections)
    if (section.sh_type == SHT_DYNSYM && section.sh_link < sections.size())
      return symbols_in(file, section, sections[section.sh_link]);
  return {};
}

}  // namespace opal
