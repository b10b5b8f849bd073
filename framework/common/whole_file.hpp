#pragma once

#include <opal/common/export.hpp>

#include <string>
#include <string_view>

namespace opal {

/// A file that appears under its name when it is whole. Until then it is a draft beside it, and the file that was there
/// before stays. What is no ordinary file, as a pipe or /dev/stdout, is written directly.
class OPAL_EXPORT WholeFile {
 public:
  /// Makes the draft. @throws WriteError naming the file and the cause.
  explicit WholeFile(const std::string& path);
  /// Removes the draft unless the file was finished.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// @throws WriteError
  void write(std::string_view text);
  /// A descriptor for who writes by other means; it stays this object's own.
  int descriptor() const { return file_; }
  /// What was written is on the disk, and the file has its name. @throws WriteError
  void finish();

 private:
  [[noreturn]] void fail(int cause);
  void close_file();

  std::string path_;    ///< as the caller calls it
  std::string target_;  ///< where a link leads
  std::string draft_;   ///< empty: written directly
  int file_ = -1;
};

/// Makes a folder with those above it. @throws WriteError naming it and the cause.
OPAL_EXPORT void make_folder(const std::string& path);

}  // namespace opal
