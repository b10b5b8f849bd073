#include "grey_image.hpp"

#include "bmp.hpp"
#include "jpeg.hpp"
#include "netpbm.hpp"

#include <opal/common/error.hpp>

#include <fmt/format.h>

#include <png.h>

#include <cstdint>
#include <numeric>

namespace opal::grid_importer {
namespace {

// 2^26 cells are 400 m x 400 m at 0.05 m and half a GiB while reading: more than a building, less than a machine.
constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 26;
// A byte of deflate data gives at most 1032 bytes (zlib's technical details), and these at most 8 pixels each.
constexpr std::uint64_t kMaxPixelsPerByte = 8 * 1032;

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
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // libpng takes 16 bit for linear light unless the file says otherwise
  png.format = colours == 3 ? PNG_FORMAT_RGBA : PNG_FORMAT_GA;
  std::vector<std::uint8_t> samples(PNG_IMAGE_SIZE(png));
  GreyImage image{static_cast<int>(png.width), static_cast<int>(png.height), {}, {}};
  if (!png_image_finish_read(&png, nullptr, samples.data(), 0, nullptr))
    throw MapError(name + ": pixels: libpng: " + png.message + ", expected an undamaged PNG image");
  take_pixels(samples, colours, has_alpha, image);
  return image;
}

}  // namespace

void check_size(std::uint64_t width, std::uint64_t height, const std::string& name) {
  const std::string found = fmt::format("{} x {} pixels", width, height);
  if (width == 0 || height == 0) throw MapError(name + ": header: " + found + ", expected at least 1 x 1");
  if (width > kMaxPixels || height > kMaxPixels || width * height > kMaxPixels)
    throw MapError(fmt::format("{}: header: {}, expected at most {} in all", name, found, kMaxPixels));
}

GreyImage decode_image(const std::string& bytes, const std::string& name) {
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') return read_netpbm(bytes, name);
  if (bytes.starts_with("\x89PNG")) return read_png(bytes, name);
  if (bytes.starts_with("BM")) return read_bmp(bytes, name);
  if (bytes.starts_with("\xFF\xD8")) return read_jpeg(bytes, name);
  if (bytes.starts_with("version https://git-lfs"))
    throw MapError(name + ": is a pointer of Git LFS, expected the image itself (git lfs pull fetches it)");
  throw MapError(
      name +
      ": byte 0: neither \"P1\" to \"P6\", \"BM\" nor a PNG or JPEG signature, expected a PNG, PGM, PPM, BMP or "
      "JPEG image");
}

}  // namespace opal::grid_importer
