#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct gzFile_s;

namespace opal::carmen_log {

struct Line {
  std::string_view text;   ///< without its end; valid until the next line is read
  bool terminated = true;  ///< false: the file ends before the line does
};

/// The lines of a text file, plain or gzip-compressed, one after the other.
class GzLines {
 public:
  /// @throws LogError if the file cannot be opened.
  explicit GzLines(const std::string& path);

  std::optional<Line> next();
  /// The text from here to as far as it is read ahead, at least one block or the rest of the file.
  std::string_view peek();

  double progress() const;  ///< share of the (compressed) file, in [0, 1]
  /// Lines that were too long to be records of a log, and were passed over.
  int overlong() const { return overlong_; }
  /// What ended the file early, if anything did: "truncated file" or "damaged compression".
  const char* damage() const { return damage_; }

 private:
  struct Close {
    void operator()(gzFile_s* file) const;
  };

  bool read_block();
  Line take(std::size_t length, bool terminated);

  std::unique_ptr<gzFile_s, Close> file_;
  std::uintmax_t file_bytes_ = 0;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // of what is read and not yet taken
  std::size_t end_ = 0;
  bool at_end_ = false;
  int overlong_ = 0;
  const char* damage_ = nullptr;
};

}  // namespace opal::carmen_log
