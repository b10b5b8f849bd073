#include "netpbm.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>

namespace opal::grid_importer {
namespace {

/// See the man pages pbm(5), pgm(5) and ppm(5).
class NetpbmReader {
 public:
  NetpbmReader(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  GreyImage read() {
    const int kind = bytes_[1] - '0';
    const bool is_plain = kind <= 3, is_bitmap = kind == 1 || kind == 4;
    channels_ = kind == 3 || kind == 6 ? 3 : 1;
    at_ = 2;
    const std::uint64_t width = number("the width");
    const std::uint64_t height = number("the height");
    check_size(width, height, name_);
    if (!is_bitmap) brightest_ = number("the brightest value");
    if (brightest_ == 0 || brightest_ > 65535) refuse(std::to_string(brightest_), "a brightest value from 1 to 65535");
    image_.width = static_cast<int>(width);
    image_.height = static_cast<int>(height);
    image_.brightness.reserve(width * height);
    if (is_bitmap && is_plain)
      read_plain_bits(width * height);
    else if (is_bitmap)
      read_raw_bits();
    else if (is_plain)
      read_plain(width * height);
    else
      read_raw(width * height);
    return std::move(image_);
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw MapError(fmt::format("{}: byte {}: {}, expected {}", name_, at_, found, expected));
  }

  void skip_space() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#')
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      else if (std::isspace(static_cast<unsigned char>(bytes_[at_])))
        ++at_;
      else
        return;
    }
  }

  std::uint64_t number(const std::string& what) {
    skip_space();
    if (at_ >= bytes_.size()) refuse("end of file", what);
    if (!std::isdigit(static_cast<unsigned char>(bytes_[at_]))) refuse("no number", what);
    std::uint64_t value = 0;
    for (; at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])); ++at_) {
      value = 10 * value + static_cast<std::uint64_t>(bytes_[at_] - '0');
      if (value > std::numeric_limits<std::uint32_t>::max()) refuse("a number above 2^32", what);
    }
    return value;
  }

  void check_remaining(std::uint64_t needed) const {
    const std::uint64_t there = bytes_.size() - std::min(at_, bytes_.size());
    if (there < needed)
      refuse(fmt::format("{} bytes of pixels until the end of the file", there),
             fmt::format("{} for {} x {}", needed, image_.width, image_.height));
  }

  /// The mean of a pixel's channels.
  template <class Next>
  void push(Next next) {
    float sum = 0;
    for (int channel = 0; channel < channels_; ++channel) {
      const std::uint64_t value = next();
      if (value > brightest_) refuse(std::to_string(value), fmt::format("a pixel of at most {}", brightest_));
      sum += static_cast<float>(value) / static_cast<float>(brightest_);
    }
    image_.brightness.push_back(channels_ == 1 ? sum : sum / static_cast<float>(channels_));
  }

  std::uint64_t values(std::uint64_t pixels) const { return pixels * static_cast<std::uint64_t>(channels_); }

  void read_plain(std::uint64_t pixels) {
    check_remaining(2 * values(pixels));  // a separator and a digit each
    for (std::uint64_t k = 0; k < pixels; ++k) push([&] { return number("pixel " + std::to_string(k)); });
  }

  void read_raw(std::uint64_t pixels) {
    ++at_;  // exactly one white space
    const bool wide = brightest_ > 255;
    check_remaining((wide ? 2 : 1) * values(pixels));
    for (std::uint64_t k = 0; k < pixels; ++k)
      push([&] {
        const std::uint64_t first = byte();
        return wide ? 256 * first + byte() : first;
      });
  }

  /// 1 is black; white space between the digits may be absent.
  void read_plain_bits(std::uint64_t pixels) {
    check_remaining(pixels);
    for (std::uint64_t k = 0; k < pixels; ++k) {
      skip_space();
      if (at_ >= bytes_.size()) refuse("end of file", "pixel " + std::to_string(k));
      const char digit = bytes_[at_];
      if (digit != '0' && digit != '1') refuse("neither 0 nor 1", "pixel " + std::to_string(k));
      ++at_;
      image_.brightness.push_back(digit == '0' ? 1 : 0);
    }
  }

  /// Eight pixels a byte; each row begins with a byte of its own.
  void read_raw_bits() {
    ++at_;
    const auto row_bytes = (static_cast<std::uint64_t>(image_.width) + 7) / 8;
    check_remaining(row_bytes * static_cast<std::uint64_t>(image_.height));
    for (int row = 0; row < image_.height; ++row) {
      std::uint64_t bits = 0;
      for (int column = 0; column < image_.width; ++column) {
        if (column % 8 == 0) bits = byte();
        image_.brightness.push_back(bits & (0x80U >> (column % 8)) ? 0 : 1);
      }
    }
  }

  std::uint64_t byte() { return static_cast<unsigned char>(bytes_[at_++]); }

  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::uint64_t brightest_ = 1;
  int channels_ = 1;
  GreyImage image_;
};

}  // namespace

GreyImage read_netpbm(const std::string& bytes, const std::string& name) { return NetpbmReader(bytes, name).read(); }

}  // namespace opal::grid_importer
