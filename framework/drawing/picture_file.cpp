#include "drawing/picture_file.hpp"

#include <opal/common/error.hpp>

#include <cairo-svg.h>

#include <memory>

namespace opal {
namespace {

constexpr double kPngScale = 1.5;

void expect_success(cairo_status_t status, const std::string& path) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(path + ": picture cannot be written: " + cairo_status_to_string(status));
}

}  // namespace

void write_svg_picture(const std::string& path, const Point& size_px, const DrawPicture& draw) {
  const Surface surface(cairo_svg_surface_create(path.c_str(), size_px.x(), size_px.y()));
  expect_success(cairo_surface_status(surface.get()), path);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  draw(surface.get());
  cairo_surface_finish(surface.get());
  expect_success(cairo_surface_status(surface.get()), path);
}

void write_png_picture(const std::string& path, const Point& size_px, const DrawPicture& draw) {
  const Point pixels = kPngScale * size_px;
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(pixels.x()), static_cast<int>(pixels.y())));
  cairo_surface_set_device_scale(surface.get(), kPngScale, kPngScale);
  draw(surface.get());
  expect_success(cairo_surface_write_to_png(surface.get(), path.c_str()), path);
}

}  // namespace opal
