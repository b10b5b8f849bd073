#include "drawing/picture_file.hpp"

#include <opal/common/error.hpp>
#include "common/text_file.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <map>
#include <string>

namespace opal {
namespace {

constexpr double kPngScale = 1.5;

void expect_success(cairo_status_t status, const std::string& path) {
  if (status != CAIRO_STATUS_SUCCESS) throw Error(path + ": cannot be drawn: " + cairo_status_to_string(status));
}

/// Cairo writes into a text first: the file appears when the picture is whole.
cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// Draws on a surface that writes into a text.
void draw_whole(const std::string& path, const CairoSurface& surface, const DrawPicture& draw) {
  draw(surface.get());
  cairo_surface_finish(surface.get());
  expect_success(cairo_surface_status(surface.get()), path);
}

/// Cairo numbers the surfaces of a process: numbered within one picture, it does not depend on those before. Text is
/// drawn as shapes, so nothing else in the picture is called so.
std::string numbered_anew(const std::string& svg) {
  static const std::string kId = "surface";
  std::map<std::string, std::size_t> numbers;
  std::string text;
  std::size_t from = 0;
  for (std::size_t at = svg.find(kId); at != std::string::npos; at = svg.find(kId, from)) {
    const std::size_t begin = at + kId.size();
    const std::size_t end = std::min(svg.find_first_not_of("0123456789", begin), svg.size());
    text += svg.substr(from, begin - from);
    if (end > begin)
      text += std::to_string(numbers.emplace(svg.substr(begin, end - begin), numbers.size() + 1).first->second);
    from = end;
  }
  return text + svg.substr(from);
}

}  // namespace

void write_svg_picture(const std::string& path, const Point& size_px, const DrawPicture& draw) {
  std::string picture;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append, &picture, size_px.x(), size_px.y()));
  expect_success(cairo_surface_status(surface.get()), path);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  draw_whole(path, surface, draw);
  write_text(path, numbered_anew(picture));
}

void write_pdf_picture(const std::string& path, const Point& size_px, const DrawPicture& draw) {
  std::string picture;
  const CairoSurface surface(cairo_pdf_surface_create_for_stream(append, &picture, size_px.x(), size_px.y()));
  expect_success(cairo_surface_status(surface.get()), path);
  // Else cairo writes the time of day, and no two files are the same.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  draw_whole(path, surface, draw);
  write_text(path, picture);
}

void write_png_picture(const std::string& path, const Point& size_px, const DrawPicture& draw) {
  const Point pixels = kPngScale * size_px;
  const CairoSurface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(pixels.x()), static_cast<int>(pixels.y())));
  cairo_surface_set_device_scale(surface.get(), kPngScale, kPngScale);
  draw(surface.get());
  std::string picture;
  expect_success(cairo_surface_write_to_png_stream(surface.get(), append, &picture), path);
  write_text(path, picture);
}

}  // namespace opal
