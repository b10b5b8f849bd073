#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace opal {

/// Reads a text file line by line, fast, with a bound on the length of a line.
class LineReader {
 public:
  static constexpr std::size_t kLongest = 64u << 20;

  /// @throws EventError naming the file if it cannot be opened.
  explicit LineReader(const std::string& path);

  /// Goes to the next line. @return false at the end. @throws EventError if it cannot be read, or a line is
  /// too long.
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }  ///< of the line, from 1
  bool is_whole() const { return whole_; }        ///< it ends with a newline

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  bool refill();

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what is not yet read in the buffer
  std::string_view line_;
  std::size_t number_ = 0;
  bool whole_ = false;
};

}  // namespace opal
