#include "grey_image.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <png.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>
#include <numeric>

namespace opal::grid_importer {
namespace {

// 2^26 cells are 400 m x 400 m at 0.05 m and half a GiB while reading: more than a building, less than a machine.
constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 26;
// A byte of deflate data gives at most 1032 bytes (zlib's technical details), and these at most 8 pixels each.
constexpr std::uint64_t kMaxPixelsPerByte = 8 * 1032;

void check_size(std::uint64_t width, std::uint64_t height, const std::string& name) {
  const std::string found = fmt::format("{} x {} pixels", width, height);
  if (width == 0 || height == 0) throw MapError(name + ": header: " + found + ", expected at least 1 x 1");
  if (width > kMaxPixels || height > kMaxPixels || width * height > kMaxPixels)
    throw MapError(fmt::format("{}: header: {}, expected at most {} in all", name, found, kMaxPixels));
}

/// Netpbm's PGM, see its man page pgm(5).
class PgmReader {
 public:
  PgmReader(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  GreyImage read() {
    const bool plain = bytes_[1] == '2';
    at_ = 2;
    const std::uint64_t width = number("the width");
    const std::uint64_t height = number("the height");
    check_size(width, height, name_);
    brightest_ = number("the brightest value");
    if (brightest_ == 0 || brightest_ > 65535) refuse(std::to_string(brightest_), "a brightest value from 1 to 65535");
    image_.width = static_cast<int>(width);
    image_.height = static_cast<int>(height);
    if (plain)
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

  void push(std::uint64_t value) {
    if (value > brightest_) refuse(std::to_string(value), fmt::format("a pixel of at most {}", brightest_));
    image_.brightness.push_back(static_cast<float>(value) / static_cast<float>(brightest_));
  }

  void read_plain(std::uint64_t pixels) {
    check_remaining(2 * pixels);  // a separator and a digit each
    image_.brightness.reserve(pixels);
    for (std::uint64_t k = 0; k < pixels; ++k) push(number("pixel " + std::to_string(k)));
  }

  void read_raw(std::uint64_t pixels) {
    ++at_;  // exactly one white space
    const bool wide = brightest_ > 255;
    check_remaining(wide ? 2 * pixels : pixels);
    image_.brightness.reserve(pixels);
    for (std::uint64_t k = 0; k < pixels; ++k) push(wide ? 256 * byte() + byte() : byte());
  }

  std::uint64_t byte() { return static_cast<unsigned char>(bytes_[at_++]); }

  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::uint64_t brightest_ = 0;
  GreyImage image_;
};

/// Frees libpng's state however the reading ends.
struct PngState : png_image {
  PngState() : png_image() { version = PNG_IMAGE_VERSION; }
  ~PngState() { png_image_free(this); }
  PngState(const PngState&) = delete;
  PngState& operator=(const PngState&) = delete;
};

/// @param samples  pixels of `colours` channels and one of opacity.
void take_pixels(const std::vector<std::uint8_t>& samples, std::size_t colours, bool has_alpha, GreyImage& image) {
  const std::size_t pixels = samples.size() / (colours + 1);
  image.brightness.resize(pixels);
  if (has_alpha) image.opacity.resize(pixels);
  for (std::size_t k = 0; k < pixels; ++k) {
    const std::uint8_t* const p = &samples[k * (colours + 1)];
    image.brightness[k] =
        static_cast<float>(std::accumulate(p, p + colours, 0)) / (255.0F * static_cast<float>(colours));
    if (has_alpha) image.opacity[k] = static_cast<float>(p[colours]) / 255.0F;
  }
}

GreyImage read_png(const std::string& bytes, const std::string& name) {
  PngState png;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
    throw MapError(name + ": header: libpng: " + png.message + ", expected a PNG image");
  check_size(png.width, png.height, name);
  if (std::uint64_t{png.width} * png.height > kMaxPixelsPerByte * bytes.size())
    throw MapError(fmt::format("{}: header: {} x {} pixels in a file of {} bytes, expected a whole PNG image", name,
                               png.width, png.height, bytes.size()));
  const bool has_alpha = png.format & PNG_FORMAT_FLAG_ALPHA;
  const std::size_t colours = png.format & PNG_FORMAT_FLAG_COLOR ? 3 : 1;
  png.format = colours == 3 ? PNG_FORMAT_RGBA : PNG_FORMAT_GA;
  std::vector<std::uint8_t> samples(PNG_IMAGE_SIZE(png));
  GreyImage image{static_cast<int>(png.width), static_cast<int>(png.height), {}, {}};
  if (!png_image_finish_read(&png, nullptr, samples.data(), 0, nullptr))
    throw MapError(name + ": pixels: libpng: " + png.message + ", expected an undamaged PNG image");
  take_pixels(samples, colours, has_alpha, image);
  return image;
}

}  // namespace

GreyImage decode_image(const std::string& bytes, const std::string& name) {
  if (bytes.rfind("P5", 0) == 0 || bytes.rfind("P2", 0) == 0) return PgmReader(bytes, name).read();
  if (bytes.rfind("\x89PNG", 0) == 0) return read_png(bytes, name);
  throw MapError(name + ": byte 0: neither \"P5\", \"P2\" nor a PNG signature, expected a PGM or PNG image");
}

}  // namespace opal::grid_importer
