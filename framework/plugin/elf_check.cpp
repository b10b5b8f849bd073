// ELF-64 object file format: System V ABI, chapters 4 (object files) and 5 (program loading).
#include "plugin/elf_check.hpp"

#include "plugin/elf_file.hpp"

#include <bit>
#include <cstring>

namespace opal {
namespace {

constexpr const char* kTruncated = "is truncated: ";
constexpr unsigned char kHostOrder = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;

std::string header_defect(const Elf64_Ehdr& header) {
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return "is not a 64-bit library";
  if (header.e_ident[EI_DATA] != kHostOrder) return "is built for a machine of the other byte order";
  if (header.e_type != ET_DYN) return "is an ELF file, but no shared library";
  if (header.e_phentsize != sizeof(Elf64_Phdr) || header.e_phnum == 0) return "has no valid program headers";
  return {};
}

std::string segment_defect(ElfFile& file, const Elf64_Ehdr& header) {
  const auto segments = file.read<Elf64_Phdr>(header.e_phoff, header.e_phnum);
  if (segments.empty()) return kTruncated + std::string("its program headers are beyond the end of the file");
  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type == PT_LOAD && !file.holds(segment.p_offset, segment.p_filesz))
      return kTruncated + std::string("it has ") + std::to_string(file.size()) + " bytes, a segment ends at byte " +
             std::to_string(segment.p_offset + segment.p_filesz);
  }
  return {};
}

bool is_text_table(ElfFile& file, const Elf64_Shdr& section) {
  if (section.sh_size == 0 || !file.holds(section.sh_offset, section.sh_size)) return false;
  const auto last = file.read<char>(section.sh_offset + section.sh_size - 1, 1);
  return !last.empty() && last.front() == '\0';
}

std::string section_defect(ElfFile& file, const Elf64_Ehdr& header) {
  if (header.e_shnum == 0) return "has no section headers, so what it offers cannot be told";
  if (header.e_shentsize != sizeof(Elf64_Shdr)) return "has no valid section headers";
  const auto sections = file.read<Elf64_Shdr>(header.e_shoff, header.e_shnum);
  if (sections.empty()) return kTruncated + std::string("its section headers are beyond the end of the file");
  if (header.e_shstrndx >= sections.size() || !is_text_table(file, sections[header.e_shstrndx]))
    return "has a damaged table of section names";
  return {};
}

}  // namespace

std::string elf_defect(const std::string& path) {
  ElfFile file(path);
  if (!file.readable()) return "cannot be read";
  const auto magic = file.read<char>(0, SELFMAG);
  if (magic.empty() || std::memcmp(magic.data(), ELFMAG, SELFMAG) != 0)
    return "is no shared library: it does not begin with the ELF magic number";
  const auto header = file.read<Elf64_Ehdr>(0, 1);
  if (header.empty()) return kTruncated + std::string("its ELF header is incomplete");
  std::string defect = header_defect(header.front());
  if (defect.empty()) defect = segment_defect(file, header.front());
  if (defect.empty()) defect = section_defect(file, header.front());
  return defect;
}

}  // namespace opal
