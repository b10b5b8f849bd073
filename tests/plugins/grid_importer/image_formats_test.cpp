// The same grid in every kind of image that programs save maps in.
#include "drawn_grid.hpp"

#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>

#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>
#include <png.h>

#include <filesystem>

namespace {

using namespace opal;
using namespace opal::test;
using Catch::Matchers::Contains;

DrawnGrid drawn_room() { return DrawnGrid(61, 50).room(10, 10, 49, 39); }

std::string map_of(const std::string& image, const std::string& name, const std::string& more = "") {
  const TemporaryFolder folder;
  folder.write(name, image);
  return grid_importer()->import(folder.write("room.yaml", yaml_for(name, "[0, 0, 0]", more))).map->to_json_ld().dump();
}

/// Calls visit(shade) from the top left on.
template <class Visit>
void visit_shades(const DrawnGrid& grid, Visit visit) {
  for (int row = grid.rows() - 1; row >= 0; --row)
    for (int column = 0; column < grid.columns(); ++column) visit(grid.at(column, row));
}

/// A PNG of any colour type and depth; free space is not written as opaque if `is_paper_clear`.
std::string png_of(const DrawnGrid& grid, int colour_type, int depth, bool is_paper_clear = false) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp self, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(self))->append(reinterpret_cast<const char*>(data), size);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(grid.columns()), static_cast<png_uint_32>(grid.rows()), depth,
               colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  const std::array<std::uint8_t, 3> shades{DrawnGrid::kOccupied, DrawnGrid::kUnknown, DrawnGrid::kFree};
  std::array<png_color, 3> palette{};
  for (std::size_t k = 0; k < 3; ++k) palette[k] = {shades[k], shades[k], shades[k]};
  if (colour_type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette.data(), 3);
  png_write_info(png, info);
  std::string row;
  visit_shades(grid, [&](std::uint8_t shade) {
    const bool is_clear = is_paper_clear && shade != DrawnGrid::kOccupied;
    const auto sample = [&](std::uint8_t value) {
      row.append(static_cast<std::size_t>(depth / 8), static_cast<char>(value));
    };
    if (colour_type == PNG_COLOR_TYPE_PALETTE)
      sample(static_cast<std::uint8_t>(std::find(shades.begin(), shades.end(), shade) - shades.begin()));
    else
      for (int channel = 0; channel < (colour_type & PNG_COLOR_MASK_COLOR ? 3 : 1); ++channel)
        sample(is_clear ? 0 : shade);
    if (colour_type & PNG_COLOR_MASK_ALPHA) sample(is_clear ? 0 : 255);
    const std::size_t row_bytes = png_get_rowbytes(png, info);
    if (row.size() < row_bytes) return;
    png_write_row(png, reinterpret_cast<png_bytep>(row.data()));
    row.clear();
  });
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::string netpbm(const DrawnGrid& grid, const std::string& kind) {
  std::string bytes = kind + "\n# CREATOR: map_saver\n" + std::to_string(grid.columns()) + " " +
                      std::to_string(grid.rows()) + (kind == "P1" || kind == "P4" ? "\n" : "\n255\n");
  std::string bits;
  visit_shades(grid, [&](std::uint8_t shade) {
    if (kind == "P6") bytes += std::string(3, static_cast<char>(shade));
    if (kind == "P3")
      bytes += (std::to_string(shade) + " ") + std::to_string(shade) + " " + std::to_string(shade) + "\n";
    bits += shade == DrawnGrid::kOccupied ? '1' : '0';
  });
  if (kind == "P1") bytes += bits;
  for (std::size_t k = 0; kind == "P4" && k < bits.size(); k += static_cast<std::size_t>(grid.columns())) {
    std::string row = bits.substr(k, static_cast<std::size_t>(grid.columns()));
    row.resize((row.size() + 7) / 8 * 8, '0');
    for (std::size_t at = 0; at < row.size(); at += 8)
      bytes += static_cast<char>(std::stoi(row.substr(at, 8), nullptr, 2));
  }
  return bytes;
}

std::string little_endian(std::uint64_t value, int size) {
  std::string bytes;
  for (int k = 0; k < size; ++k, value >>= 8) bytes += static_cast<char>(value & 0xFF);
  return bytes;
}

/// @param bits  a pixel: 8 with a palette of greys, 24, or 32.
std::string bmp(const DrawnGrid& grid, int bits) {
  const std::size_t palette = bits == 8 ? 4 * 256 : 0;
  std::string bytes = "BM" + little_endian(0, 8) + little_endian(54 + palette, 4) + little_endian(40, 4) +
                      little_endian(static_cast<std::uint64_t>(grid.columns()), 4) +
                      little_endian(static_cast<std::uint64_t>(grid.rows()), 4) + little_endian(1, 2) +
                      little_endian(static_cast<std::uint64_t>(bits), 2) + little_endian(0, 24);
  for (unsigned k = 0; k < palette / 4; ++k) bytes += std::string(3, static_cast<char>(k)) + '\0';
  for (int row = 0; row < grid.rows(); ++row) {
    std::string line;
    for (int column = 0; column < grid.columns(); ++column)
      line += std::string(static_cast<std::size_t>(bits / 8), static_cast<char>(grid.at(column, row)));
    line.resize((line.size() + 3) / 4 * 4);
    bytes += line;
  }
  return bytes;
}

std::string jpeg(const DrawnGrid& grid, int quality) {
  jpeg_compress_struct state{};
  jpeg_error_mgr errors{};
  state.err = jpeg_std_error(&errors);
  jpeg_create_compress(&state);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&state, &data, &size);
  state.image_width = static_cast<unsigned>(grid.columns());
  state.image_height = static_cast<unsigned>(grid.rows());
  state.input_components = 1;
  state.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&state);
  jpeg_set_quality(&state, quality, TRUE);
  jpeg_start_compress(&state, TRUE);
  std::string row;
  visit_shades(grid, [&](std::uint8_t shade) {
    row += static_cast<char>(shade);
    if (row.size() < state.image_width) return;
    auto* pixels = reinterpret_cast<unsigned char*>(row.data());
    jpeg_write_scanlines(&state, &pixels, 1);
    row.clear();
  });
  jpeg_finish_compress(&state);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  jpeg_destroy_compress(&state);
  std::free(data);
  return bytes;
}

}  // namespace

TEST_CASE("a JPEG of a grid is nearly the same map: its shades become whole again") {
  const TemporaryFolder folder;
  const auto faces = [&](const std::string& image, const std::string& name) {
    folder.write(name, image);
    return all<Segment>(*grid_importer()->import(folder.write("room.yaml", yaml_for(name))).map);
  };
  const std::vector<Segment> exact = faces(drawn_room().pgm(), "room.pgm");
  for (const int quality : {95, 75}) {
    const std::vector<Segment> read = faces(jpeg(drawn_room(), quality), "room.jpg");
    REQUIRE(read.size() == exact.size());
    for (std::size_t k = 0; k < exact.size(); ++k) CHECK((read[k].midpoint() - exact[k].midpoint()).norm() < 0.05);
  }
}

TEST_CASE("a JPEG that was cut is refused") {
  const std::string whole = jpeg(drawn_room(), 75);
  CHECK_THROWS_WITH(map_of(whole.substr(0, whole.size() / 2), "room.jpg"), Contains("room.jpg: pixels: libjpeg"));
  CHECK_THROWS_WITH(map_of(whole.substr(0, 20), "room.jpg"), Contains("room.jpg: header: libjpeg"));
}

TEST_CASE("a grid is the same map in grey, colours, a palette, with opacity, in 8 and 16 bit") {
  const std::string expected = map_of(drawn_room().pgm(), "room.pgm");
  for (const auto& [type, depth] : std::vector<std::pair<int, int>>{{PNG_COLOR_TYPE_GRAY, 8},
                                                                    {PNG_COLOR_TYPE_GRAY, 16},
                                                                    {PNG_COLOR_TYPE_RGB, 8},
                                                                    {PNG_COLOR_TYPE_RGB, 16},
                                                                    {PNG_COLOR_TYPE_PALETTE, 8}}) {
    CAPTURE(type, depth);
    CHECK(map_of(png_of(drawn_room(), type, depth), "room.png") == expected);
  }
  for (const int depth : {8, 16})  // in trinary mode, opacity is averaged in
    for (const int type : {PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB_ALPHA}) {
      CHECK(map_of(png_of(drawn_room(), type, depth), "room.png", "mode: scale\n") == expected);
      CHECK(map_of(png_of(drawn_room(), type, depth), "room.png") == expected);  // grey of unknown cells stays unknown
    }
  for (const char* kind : {"P3", "P6"}) CHECK(map_of(netpbm(drawn_room(), kind), "room.ppm") == expected);
  for (const int bits : {8, 24, 32}) CHECK(map_of(bmp(drawn_room(), bits), "room.bmp") == expected);
}

TEST_CASE("16 bit are no linear light: grey stays as dark as it is") {
  DrawnGrid faint = drawn_room();
  for (int row = 0; row < faint.rows(); ++row)
    for (int column = 0; column < faint.columns(); ++column)
      if (faint.at(column, row) == DrawnGrid::kOccupied) faint.at(column, row) = 70;  // occupied with 0.73
  const std::string expected = map_of(faint.pgm(), "room.pgm");
  CHECK(map_of(png_of(faint, PNG_COLOR_TYPE_GRAY, 16), "room.png") == expected);
  CHECK(map_of(png_of(faint, PNG_COLOR_TYPE_RGB, 16), "room.png") == expected);
}

TEST_CASE("a plan of black on white is read from bits") {
  DrawnGrid plan = drawn_room();
  for (int row = 0; row < plan.rows(); ++row)
    for (int column = 0; column < plan.columns(); ++column)
      if (plan.at(column, row) == DrawnGrid::kUnknown) plan.at(column, row) = DrawnGrid::kFree;
  const std::string expected = map_of(plan.pgm(), "room.pgm");
  CHECK(map_of(netpbm(plan, "P1"), "room.pbm") == expected);
  CHECK(map_of(netpbm(plan, "P4"), "room.pbm") == expected);
  for (const int type : {PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB_ALPHA})  // drawn on nothing
    CHECK(map_of(png_of(plan, type, 8, true), "room.png") == expected);
}

TEST_CASE("an image that was copied with its yaml file is found beside it") {
  const TemporaryFolder folder;
  folder.write("room.pgm", drawn_room().pgm());
  const std::string yaml = folder.write("room.yaml", "\xEF\xBB\xBF" + yaml_for("/home/nobody/maps/room.pgm"));
  CHECK(grid_importer()->recognizes(yaml));
  CHECK(grid_importer()->import(yaml).map->features().size() == 8);
}

TEST_CASE("a BMP that is damaged or compressed is refused with the place") {
  const auto message = [](const std::string& bytes) {
    return refused_with<MapError>([&] { map_of(bytes, "room.bmp"); });
  };
  std::string compressed = bmp(drawn_room(), 8);
  compressed[30] = 1;
  CHECK_THAT(message(compressed), Contains("header: compressed"));
  CHECK_THAT(message(bmp(drawn_room(), 24).substr(0, 400)), Contains("room.bmp: pixels: cut off, expected 9200 bytes"));
  CHECK_THAT(message(bmp(drawn_room(), 8).substr(0, 400)), Contains("palette: cut off"));
  CHECK_THAT(message("BM"), Contains("header: cut off"));
}
