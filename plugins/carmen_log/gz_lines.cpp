#include "gz_lines.hpp"

#include <opal/common/error.hpp>

#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace opal::carmen_log {
namespace {

constexpr std::size_t kBlockBytes = 1u << 18;
constexpr std::size_t kLongestLineBytes = 1u << 22;  // 100,000 readings of 40 characters

std::uintmax_t size_of_regular_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw LogError(path + ": no such file, expected a CARMEN log");
  if (!std::filesystem::is_regular_file(status)) throw LogError(path + ": is no regular file, expected a CARMEN log");
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  return error ? 0 : bytes;
}

}  // namespace

void GzLines::Close::operator()(gzFile_s* file) const { gzclose(file); }

GzLines::GzLines(const std::string& path) : file_bytes_(size_of_regular_file(path)) {
  file_.reset(gzopen(path.c_str(), "rb"));
  if (!file_) throw LogError(path + ": cannot be opened: " + std::strerror(errno));
  gzbuffer(file_.get(), kBlockBytes);
}

bool GzLines::read_block() {
  if (at_end_) return false;
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), buffer_.begin() + static_cast<std::ptrdiff_t>(end_),
            buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() < end_ + kBlockBytes) buffer_.resize(end_ + kBlockBytes);
  const int bytes = gzread(file_.get(), buffer_.data() + end_, kBlockBytes);
  int error = Z_OK;
  gzerror(file_.get(), &error);
  if (error == Z_BUF_ERROR) damage_ = "truncated file";
  if (bytes < 0 || error == Z_DATA_ERROR) damage_ = "damaged compression";
  if (bytes > 0) end_ += static_cast<std::size_t>(bytes);
  at_end_ = bytes <= 0;  // zlib tells of the end before all that precedes it is handed out
  return bytes > 0;
}

Line GzLines::take(std::size_t length, bool terminated) {
  std::string_view text(buffer_.data() + begin_, length);
  begin_ += length + (terminated ? 1 : 0);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  return {text, terminated};
}

std::optional<Line> GzLines::next() {
  std::size_t searched = 0;
  bool skipping = false;
  while (true) {
    const char* from = buffer_.data() + begin_ + searched;
    const void* newline = end_ > begin_ + searched ? std::memchr(from, '\n', end_ - begin_ - searched) : nullptr;
    if (newline) {
      const Line line =
          take(static_cast<std::size_t>(static_cast<const char*>(newline) - buffer_.data()) - begin_, true);
      if (!skipping) return line;
      skipping = false;
      searched = 0;
      continue;
    }
    searched = end_ - begin_;
    if (searched > kLongestLineBytes) {
      if (!skipping) ++overlong_;
      skipping = true;
      begin_ = end_;
      searched = 0;
    }
    if (read_block()) continue;
    if (begin_ == end_ || skipping) return std::nullopt;
    return take(end_ - begin_, false);
  }
}

std::string_view GzLines::peek() {
  if (begin_ == end_) read_block();
  return {buffer_.data() + begin_, end_ - begin_};
}

double GzLines::progress() const {
  if (at_end_ && begin_ == end_) return 1;
  const auto offset = static_cast<double>(std::max<z_off_t>(gzoffset(file_.get()), 0));
  return file_bytes_ == 0 ? 1 : std::min(1.0, offset / static_cast<double>(file_bytes_));
}

}  // namespace opal::carmen_log
