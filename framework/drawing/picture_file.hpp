#pragma once

#include <opal/common/geometry.hpp>

#include <cairo.h>

#include <functional>
#include <string>

namespace opal {

using DrawPicture = std::function<void(cairo_surface_t*)>;

/// Write what is drawn on a page of some size. @throws Error naming the file if it cannot be written.
void write_svg_picture(const std::string& path, const Point& size_px, const DrawPicture& draw);
void write_png_picture(const std::string& path, const Point& size_px, const DrawPicture& draw);

}  // namespace opal
