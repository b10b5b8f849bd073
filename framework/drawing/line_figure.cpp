#include "drawing/drawing_layers.hpp"
#include "drawing/figure.hpp"
#include "drawing/figure_frame.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace opal {
namespace {

constexpr double kLineWidth_px = 460, kPanel_px = 78, kPanelGap_px = 24, kBar_px = 10, kKeyRow_px = 16;

/// What the colours of the spans mean, each once.
std::map<std::string, std::string> meanings_of(const LinePlot& plot) {
  std::map<std::string, std::string> meanings;
  for (const LinePlot::Span& span : plot.spans) meanings.emplace(span.tone, span.title);
  return meanings;
}

Point line_size_px(const LinePlot& plot) {
  return {kLineWidth_px, static_cast<double>(plot.lines.size()) * (kPanel_px + kPanelGap_px) + kBar_px + 50 +
                             kKeyRow_px * static_cast<double>(meanings_of(plot).size())};
}

void draw_panel(DrawingCanvas& canvas, const LinePlot& plot, const LinePlot::Line& line, const PlotScale& x,
                const PlotBox& box) {
  const PlotScale y(line.upwards, line.y, box.bottom, box.top);
  draw_axis_left(canvas, y, box, 3);
  figure_text(canvas, {box.left, box.top - 6}, title_of(line.upwards), Align::begin, kFigureText_px, ink::kText);
  const std::size_t count = std::min(plot.x.size(), line.y.size());
  for (std::size_t k = 1; k < count; ++k)
    if (std::isfinite(line.y[k - 1]) && std::isfinite(line.y[k]))
      canvas.page_line({x.px(plot.x[k - 1]), y.px(line.y[k - 1])}, {x.px(plot.x[k]), y.px(line.y[k])},
                       tone_color(line.tone), 1.3);
}

void draw_key(DrawingCanvas& canvas, const LinePlot& plot, const Point& corner_px) {
  double y = corner_px.y();
  for (const auto& [tone, meaning] : meanings_of(plot)) {
    canvas.page_rectangle({corner_px.x(), y - 8}, {12, 8}, tone_color(tone));
    figure_text(canvas, {corner_px.x() + 18, y}, meaning, Align::begin, kFigureTick_px, ink::kText);
    y += kKeyRow_px;
  }
}

void draw_lines(DrawingCanvas& canvas, const LinePlot& plot) {
  const double left = 52, right = kLineWidth_px - 12;
  std::vector<double> values = plot.x;
  for (const LinePlot::Span& span : plot.spans) values.push_back(span.to);
  const PlotScale x(plot.across, values, left, right);
  double top = kPanelGap_px;
  for (const LinePlot::Line& line : plot.lines) {
    draw_panel(canvas, plot, line, x, {left, right, top, top + kPanel_px});
    top += kPanel_px + kPanelGap_px;
  }
  const PlotBox bar{left, right, top - kPanelGap_px / 2, top - kPanelGap_px / 2 + kBar_px};
  draw_axis_below(canvas, x, bar, 6);
  for (const LinePlot::Span& span : plot.spans)
    canvas.page_rectangle({x.px(span.from), bar.top}, {std::max(0.5, x.px(span.to) - x.px(span.from)), kBar_px},
                          tone_color(span.tone));
  figure_text(canvas, {(left + right) / 2, bar.bottom + 28}, title_of(plot.across), Align::middle, kFigureText_px,
              ink::kText);
  draw_key(canvas, plot, {left, bar.bottom + 46});
}

}  // namespace

void write_figure(const std::string& path, const LinePlot& plot) {
  write_vector_files(path, line_size_px(plot), [&](DrawingCanvas& canvas) { draw_lines(canvas, plot); });
}

}  // namespace opal
