#pragma once

#include <opal/common/geometry.hpp>

#include <cairo.h>

#include <functional>
#include <memory>
#include <string>

namespace opal {

struct ReleaseSurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, ReleaseSurface>;

using DrawPicture = std::function<void(cairo_surface_t*)>;

/// Write what is drawn on a page of some size. The same picture gives the same bytes. @throws Error naming the file if
/// it cannot be written.
void write_svg_picture(const std::string& path, const Point& size_px, const DrawPicture& draw);
void write_pdf_picture(const std::string& path, const Point& size_px, const DrawPicture& draw);
void write_png_picture(const std::string& path, const Point& size_px, const DrawPicture& draw);

}  // namespace opal
