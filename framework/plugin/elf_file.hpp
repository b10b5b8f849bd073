#pragma once

#include <elf.h>

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace opal {

/// A file that may be an ELF library. Nothing is read from beyond its end.
class ElfFile {
 public:
  explicit ElfFile(const std::string& path) : file_(path, std::ios::binary) {
    file_.seekg(0, std::ios::end);
    size_ = file_ ? static_cast<std::uint64_t>(file_.tellg()) : 0;
  }

  bool readable() const { return file_.is_open() && file_.good(); }
  std::uint64_t size() const { return size_; }
  bool holds(std::uint64_t offset, std::uint64_t bytes) const { return offset <= size_ && bytes <= size_ - offset; }

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

}  // namespace opal
