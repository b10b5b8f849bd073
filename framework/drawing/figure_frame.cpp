#include "drawing/figure_frame.hpp"

#include "drawing/drawing_layers.hpp"

#include <map>

namespace opal {
namespace {

Color hex_color(unsigned rgb) {
  const auto part = [&](int shift) { return static_cast<double>((rgb >> shift) & 0xff) / 255; };
  return {part(16), part(8), part(0)};
}

}  // namespace

Color tone_color(const std::string& tone) {
  static const std::map<std::string, unsigned> kTones{
      {"a", 0x1a6bd1},         {"b", 0xa85200},      {"c", 0x5b3a9e},       {"good", 0x05804d},
      {"bad", 0xb3261e},       {"doubt", 0xc79100},  {"equal", 0x71809a},   {"nothing", 0xc9ccd1},
      {"localized", 0x009e73}, {"unsure", 0x0072b2}, {"unknown", 0xe69f00}, {"wrong", 0xd55e00}};
  const auto found = kTones.find(tone);
  return found == kTones.end() ? ink::kText : hex_color(found->second);
}

void figure_text(DrawingCanvas& canvas, const Point& at_px, const std::string& text, Align align, double size_px,
                 const Color& color) {
  const double width_px = align == Align::begin ? 0 : canvas.text_width_px(text, size_px);
  canvas.text(at_px - Point(align == Align::middle ? width_px / 2 : width_px, 0), text, size_px, color);
}

void draw_axis_below(DrawingCanvas& canvas, const PlotScale& scale, const PlotBox& box, int count) {
  for (const double tick : scale.ticks(count)) {
    const double x = scale.px(tick);
    canvas.page_line({x, box.top}, {x, box.bottom}, ink::kGrid, 1);
    figure_text(canvas, {x, box.bottom + 14}, tick_text(tick), Align::middle, kFigureTick_px, ink::kFaintText);
  }
}

void draw_axis_left(DrawingCanvas& canvas, const PlotScale& scale, const PlotBox& box, int count) {
  for (const double tick : scale.ticks(count)) {
    const double y = scale.px(tick);
    canvas.page_line({box.left, y}, {box.right, y}, ink::kGrid, 1);
    figure_text(canvas, {box.left - 6, y + 3.5}, tick_text(tick), Align::end, kFigureTick_px, ink::kFaintText);
  }
}

DrawingCanvas figure_canvas(cairo_surface_t* surface, const Point& size_px) {
  DrawingCanvas canvas(surface, {{0, 0}, {0, size_px.y()}, size_px, 1});
  canvas.page_rectangle({0, 0}, size_px, ink::kPlot);
  return canvas;
}

void write_vector_files(const std::string& path, const Point& size_px,
                        const std::function<void(DrawingCanvas&)>& draw) {
  const auto on_surface = [&](cairo_surface_t* surface) {
    DrawingCanvas canvas = figure_canvas(surface, size_px);
    draw(canvas);
  };
  write_svg_picture(path + ".svg", size_px, on_surface);
  write_pdf_picture(path + ".pdf", size_px, on_surface);
}

double figure_text_width_px(const std::string& text, double size_px) {
  const CairoSurface nowhere(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  return DrawingCanvas(nowhere.get(), {}).text_width_px(text, size_px);
}

}  // namespace opal
