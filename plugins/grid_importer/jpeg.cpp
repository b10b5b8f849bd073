#include "jpeg.hpp"

#include <opal/common/error.hpp>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <memory>

// After <cstdio>, which it needs and does not include.
#include <jpeglib.h>

#include <jerror.h>

namespace opal::grid_importer {
namespace {

// What map_saver writes for occupied, unknown and free cells, and how far compression moves a shade.
constexpr std::array kShades{0.0F, 205 / 255.0F, 254 / 255.0F};
constexpr float kNoise = 0.08F;
// As of a PNG, which is packed tighter.
constexpr std::uint64_t kMaxJpegPixelsPerByte = 8 * 1032;
// Of all pixels: near one of the shades, and near that of unknown cells, which no drawing on white paper has so often.
constexpr double kNearShare = 0.97, kUnknownShare = 0.01;

/// libjpeg jumps out of its functions where something is wrong. Nothing between has a destructor.
struct Errors : jpeg_error_mgr {
  std::jmp_buf out{};
  std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void jump_out(j_common_ptr state) {
  auto* errors = static_cast<Errors*>(state->err);
  errors->format_message(state, errors->message.data());
  std::longjmp(errors->out, 1);
}

/// Of a file that was cut, libjpeg makes grey pixels and only warns. Other warnings change nothing.
void take_warning(j_common_ptr state, int level) {
  const int code = state->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER)) jump_out(state);
}

struct Decoder {
  jpeg_decompress_struct state{};
  Errors errors{};
  std::vector<unsigned char> pixels = {};

  Decoder() = default;
  ~Decoder() { jpeg_destroy_decompress(&state); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
};

/// @return whether the header could be read.
bool read_header(Decoder& decoder, const std::string& bytes) {
  decoder.state.err = jpeg_std_error(&decoder.errors);
  decoder.errors.error_exit = &jump_out;
  decoder.errors.emit_message = &take_warning;
  if (setjmp(decoder.errors.out) != 0) return false;
  jpeg_create_decompress(&decoder.state);
  jpeg_mem_src(&decoder.state, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&decoder.state, TRUE);
  decoder.state.out_color_space = JCS_GRAYSCALE;
  return true;
}

/// @return whether all rows could be read; there is room for them.
bool read_rows(Decoder& decoder) {
  if (setjmp(decoder.errors.out) != 0) return false;
  jpeg_start_decompress(&decoder.state);
  while (decoder.state.output_scanline < decoder.state.output_height) {
    unsigned char* row =
        decoder.pixels.data() + std::size_t{decoder.state.output_scanline} * decoder.state.output_width;
    jpeg_read_scanlines(&decoder.state, &row, 1);
  }
  return true;
}

float nearest_shade(float brightness) {
  return *std::min_element(kShades.begin(), kShades.end(),
                           [&](float a, float b) { return std::abs(a - brightness) < std::abs(b - brightness); });
}

void restore_shades(std::vector<float>& brightness) {
  std::size_t near = 0, unknown = 0;
  for (const float value : brightness) {
    const float shade = nearest_shade(value);
    near += std::abs(shade - value) < kNoise;
    unknown += shade == kShades[1] && std::abs(shade - value) < kNoise;
  }
  const auto all = static_cast<double>(brightness.size());
  if (static_cast<double>(near) < kNearShare * all || static_cast<double>(unknown) < kUnknownShare * all) return;
  for (float& value : brightness) value = nearest_shade(value);
}

}  // namespace

GreyImage read_jpeg(const std::string& bytes, const std::string& name) {
  const auto decoder = std::make_unique<Decoder>();
  const auto fail = [&](const char* place) {
    throw MapError(name + ": " + place + ": libjpeg: " + decoder->errors.message.data() +
                   ", expected an undamaged JPEG image");
  };
  if (!read_header(*decoder, bytes)) fail("header");
  check_size(decoder->state.image_width, decoder->state.image_height, name);
  if (std::uint64_t{decoder->state.image_width} * decoder->state.image_height > kMaxJpegPixelsPerByte * bytes.size())
    throw MapError(name + ": header: more pixels than so few bytes can hold, expected a whole JPEG image");
  decoder->pixels.resize(std::size_t{decoder->state.image_width} * decoder->state.image_height);
  if (!read_rows(*decoder)) fail("pixels");
  GreyImage image{static_cast<int>(decoder->state.image_width), static_cast<int>(decoder->state.image_height), {}, {}};
  image.brightness.resize(decoder->pixels.size());
  std::transform(decoder->pixels.begin(), decoder->pixels.end(), image.brightness.begin(),
                 [](unsigned char value) { return static_cast<float>(value) / 255.0F; });
  restore_shades(image.brightness);
  return image;
}

}  // namespace opal::grid_importer
