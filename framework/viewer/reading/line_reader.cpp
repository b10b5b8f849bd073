#include "viewer/reading/line_reader.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <cstring>

namespace opal {

LineReader::LineReader(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "rb")) {
  if (!file_) throw EventError(path + ": " + std::strerror(errno) + ", expected a readable event stream");
}

bool LineReader::next() {
  std::size_t searched = begin_;
  std::size_t end = std::string::npos;
  while ((end = buffer_.find('\n', searched)) == std::string::npos) {
    searched = buffer_.size() - begin_;  // refilling moves what is left to the front
    if (!refill()) break;
  }
  whole_ = end != std::string::npos;
  if (!whole_ && begin_ == buffer_.size()) return false;
  line_ = std::string_view(buffer_).substr(begin_, (whole_ ? end : buffer_.size()) - begin_);
  begin_ = whole_ ? end + 1 : buffer_.size();
  ++number_;
  return true;
}

bool LineReader::refill() {
  constexpr std::size_t kBlock = 1u << 18;
  buffer_.erase(0, begin_);
  begin_ = 0;
  const std::size_t kept = buffer_.size();
  if (kept > kLongest)
    throw EventError(fmt::format("{}:{}: a line of more than 64 MB, expected shorter ones", path_, number_ + 1));
  buffer_.resize(kept + kBlock);
  const std::size_t count = std::fread(buffer_.data() + kept, 1, kBlock, file_.get());
  buffer_.resize(kept + count);
  if (count == 0 && std::ferror(file_.get())) throw EventError(path_ + ": " + std::strerror(errno));
  return count > 0;
}

}  // namespace opal
