#include "drawing/picture_file.hpp"

#include <opal/common/error.hpp>
#include "common/text_file.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

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
void draw_into(const std::string& path, const CairoSurface& surface, const std::string& picture,
               const DrawPicture& draw) {
  expect_success(cairo_surface_status(surface.get()), path);
  draw(surface.get());
  cairo_surface_finish(surface.get());
  expect_success(cairo_surface_status(surface.get()), path);
  write_text(path, picture);
}

}  // namespace

void write_svg_picture(const std::string& path, const Point& size_px, const DrawPicture& draw) {
  std::string picture;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append, &picture, size_px.x(), size_px.y()));
  expect_success(cairo_surface_status(surface.get()), path);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  draw_into(path, surface, picture, draw);
}

void write_pdf_picture(const std::string& path, const Point& size_px, const DrawPicture& draw) {
  std::string picture;
  const CairoSurface surface(cairo_pdf_surface_create_for_stream(append, &picture, size_px.x(), size_px.y()));
  expect_success(cairo_surface_status(surface.get()), path);
  // Else cairo writes the time of day, and no two files are the same.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  draw_into(path, surface, picture, draw);
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
