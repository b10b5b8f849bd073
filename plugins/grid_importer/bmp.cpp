#include "bmp.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace opal::grid_importer {
namespace {

constexpr std::size_t kFileHeader = 14, kShortestHeader = 40;
constexpr std::uint32_t kUncompressed = 0, kBitFields = 3;

/// See "BITMAPINFOHEADER" in Microsoft's documentation of Windows GDI. Numbers begin with their lowest byte.
class BmpReader {
 public:
  BmpReader(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  GreyImage read() {
    if (bytes_.size() < kFileHeader + kShortestHeader) refuse("header", "cut off", "at least 54 bytes");
    const std::uint64_t begin = number(10, 4), header = number(14, 4);
    const auto width = static_cast<std::int32_t>(number(18, 4)), height = static_cast<std::int32_t>(number(22, 4));
    bits_ = number(28, 2);
    const std::uint64_t compression = number(30, 4);
    if (header < kShortestHeader) refuse("header", "of an old kind", "one of Windows 3 or later");
    const bool is_direct = bits_ == 24 || bits_ == 32;
    if (!is_direct && bits_ != 1 && bits_ != 4 && bits_ != 8)
      refuse("header", fmt::format("{} bits a pixel", bits_), "1, 4, 8, 24 or 32");
    if (compression != kUncompressed && !(compression == kBitFields && bits_ == 32))
      refuse("header", "compressed", "a BMP without compression, or a PNG image");
    check_size(width > 0 ? static_cast<std::uint64_t>(width) : 0, static_cast<std::uint64_t>(std::llabs(height)),
               name_);
    if (!is_direct) read_palette(kFileHeader + header, number(46, 4));
    image_.width = width;
    image_.height = static_cast<int>(std::llabs(height));
    read_rows(begin, height < 0);
    return std::move(image_);
  }

 private:
  [[noreturn]] void refuse(const std::string& place, const std::string& found, const std::string& expected) const {
    throw MapError(name_ + ": " + place + ": " + found + ", expected " + expected);
  }

  std::uint64_t number(std::size_t at, std::size_t size) const {
    std::uint64_t value = 0;
    for (std::size_t k = size; k-- > 0;) value = 256 * value + static_cast<unsigned char>(bytes_[at + k]);
    return value;
  }

  float mean_of(std::size_t at) const {
    return static_cast<float>(number(at, 1) + number(at + 1, 1) + number(at + 2, 1)) / (3 * 255.0F);
  }

  void read_palette(std::size_t begin, std::uint64_t stated) {
    const std::uint64_t most = std::uint64_t{1} << bits_, colours = stated == 0 || stated > most ? most : stated;
    if (begin > bytes_.size() || bytes_.size() - begin < 4 * colours)
      refuse("palette", "cut off", fmt::format("{} colours", colours));
    for (std::uint64_t k = 0; k < colours; ++k) palette_.push_back(mean_of(begin + 4 * k));
    palette_.resize(most, 0);
  }

  void read_rows(std::uint64_t begin, bool is_from_top) {
    const auto width = static_cast<std::uint64_t>(image_.width), height = static_cast<std::uint64_t>(image_.height);
    const std::uint64_t row_bytes = (width * bits_ + 31) / 32 * 4;
    if (begin > bytes_.size() || bytes_.size() - begin < row_bytes * height)
      refuse("pixels", "cut off", fmt::format("{} bytes for {} x {}", row_bytes * height, width, height));
    image_.brightness.reserve(width * height);
    for (std::uint64_t row = 0; row < height; ++row) {
      const std::uint64_t at = begin + (is_from_top ? row : height - 1 - row) * row_bytes;
      for (std::uint64_t column = 0; column < width; ++column) image_.brightness.push_back(pixel(at, column));
    }
  }

  float pixel(std::uint64_t row, std::uint64_t column) const {
    if (bits_ >= 24) return mean_of(row + column * bits_ / 8);
    const std::uint64_t bit = column * bits_, shift = 8 - bits_ - bit % 8;
    return palette_[(number(row + bit / 8, 1) >> shift) & ((1U << bits_) - 1)];
  }

  const std::string& bytes_;
  const std::string& name_;
  std::uint64_t bits_ = 0;
  std::vector<float> palette_;
  GreyImage image_;
};

}  // namespace

GreyImage read_bmp(const std::string& bytes, const std::string& name) { return BmpReader(bytes, name).read(); }

}  // namespace opal::grid_importer
