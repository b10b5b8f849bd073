#pragma once

#include "common/prepared/read_only_array.hpp"

#include <opal/common/export.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace opal {

/// How a file of sections is known.
struct SectionKey {
  std::array<char, 8> kind{};  ///< of what is in it
  std::string digest;          ///< of all that it was made of, as 64 hexadecimal digits
};

/// Plain values that are to be written side by side.
struct Section {
  template <class T>
  explicit Section(std::span<const T> values)
      : bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes()), count(values.size()) {}
  template <class T>
  explicit Section(const ReadOnlyArray<T>& array) : Section(array.values()) {}

  std::string_view bytes;
  std::uint64_t count;  ///< of values
};

inline constexpr std::size_t kMostSections = 8;

/// Writes sections one after the other, each from a page on. The file is of this kind of machine, and there when it is
/// whole. @throws WriteError
OPAL_EXPORT void write_sections(const std::filesystem::path& file, const SectionKey& key,
                                std::span<const Section> sections);

/// A file that is mapped into memory where it is read: what nobody looks at takes none.
class OPAL_EXPORT Sections {
 public:
  /// @return nothing if there is no such file, or one of another key, program or kind of machine.
  static std::optional<Sections> open(const std::filesystem::path& file, const SectionKey& key);

  /// The next one; its values keep the file mapped. None are left if the file is too short for them.
  template <class T>
  ReadOnlyArray<T> next() {
    const std::uint64_t count = section_ < counts_.size() ? counts_[section_++] : 0;
    const char* begin = take(count, sizeof(T));
    if (begin == nullptr) return {};
    return ReadOnlyArray<T>(region_, {reinterpret_cast<const T*>(begin), static_cast<std::size_t>(count)});
  }
  /// True if the file is as long as what was taken.
  bool are_whole() const { return is_whole_ && at_ == bytes_; }
  /// What was only checked need not stay in memory.
  void let_go() const;

 private:
  Sections() = default;
  const char* take(std::uint64_t count, std::size_t value_bytes);

  std::shared_ptr<void> region_;
  const char* begin_ = nullptr;
  std::size_t bytes_ = 0, at_ = 0, section_ = 0;
  std::array<std::uint64_t, kMostSections> counts_{};
  bool is_whole_ = true;
};

}  // namespace opal
