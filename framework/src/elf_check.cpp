// ELF-64 object file format: System V ABI, chapters 4 (object files) and 5 (program loading).
#include "elf_check.hpp"

#include <elf.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

namespace opal {
namespace {

constexpr const char* kTruncated = "is truncated: ";
constexpr unsigned char kHostOrder = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;

class ElfFile {
 public:
  explicit ElfFile(const std::string& path) : file_(path, std::ios::binary) {
    file_.seekg(0, std::ios::end);
    size_ = file_ ? static_cast<std::uint64_t>(file_.tellg()) : 0;
  }

  bool readable() const { return file_.is_open() && file_.good(); }
  std::uint64_t size() const { return size_; }
  bool holds(std::uint64_t offset, std::uint64_t bytes) const {
    return offset <= size_ && bytes <= size_ - offset;
  }

  /// @return empty if the file does not hold that many.
  template <class T>
  std::vector<T> read(std::uint64_t offset, std::uint64_t count) {
    if (!holds(offset, count * sizeof(T))) return {};
    std::vector<T> items(count);
    file_.seekg(static_cast<std::streamoff>(offset));
    file_.read(reinterpret_cast<char*>(items.data()), static_cast<std::streamsize>(count * sizeof(T)));
    return file_ ? items : std::vector<T>{};
  }

 private:
  std::ifstream file_;
  std::uint64_t size_ = 0;
};

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
      return kTruncated + std::string("it has ") + std::to_string(file.size()) +
             " bytes, a segment ends at byte " + std::to_string(segment.p_offset + segment.p_filesz);
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
