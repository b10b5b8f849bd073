#pragma once

#include "drawing/drawing_canvas.hpp"
#include "drawing/picture_file.hpp"
#include "drawing/plot_scale.hpp"

#include <functional>
#include <string>

namespace opal {

/// What all figures share: edges of a plot, axes, colours.
struct PlotBox {
  double left = 0, right = 0, top = 0, bottom = 0;  ///< [px], top above bottom
};

inline constexpr double kFigureText_px = 11, kFigureTick_px = 10;

/// The colour that page/style.css gives to a tone, on white paper.
Color tone_color(const std::string& tone);

enum class Align { begin, middle, end };
void figure_text(DrawingCanvas& canvas, const Point& at_px, const std::string& text, Align align, double size_px,
                 const Color& color);

/// Lines across the plot at the ticks of an axis, with their values below or to the left.
void draw_axis_below(DrawingCanvas& canvas, const PlotScale& scale, const PlotBox& box, int count);
void draw_axis_left(DrawingCanvas& canvas, const PlotScale& scale, const PlotBox& box, int count);

/// A canvas on a page of white paper; coordinates are pixels of the page.
DrawingCanvas figure_canvas(cairo_surface_t* surface, const Point& size_px);
/// Writes what is drawn as PATH.svg and PATH.pdf.
void write_vector_files(const std::string& path, const Point& size_px, const std::function<void(DrawingCanvas&)>& draw);
/// For the width of texts before there is a page.
double figure_text_width_px(const std::string& text, double size_px);

}  // namespace opal
