#include "drawing/drawing_layers.hpp"
#include "drawing/figure.hpp"
#include "drawing/figure_frame.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr double kIntervalRow_px = 20, kIntervalHead_px = 26, kIntervalFoot_px = 36, kIntervalWidth_px = 220,
                 kColumnGap_px = 14, kLeastDiamond_px = 4;  // to either side

std::string head_text(const Column& column) { return title_of({column.name, column.unit}); }

/// A forest plot (Lewis & Clarke 2001): intervals stand before the last column of the table, which says the same in
/// numbers.
class IntervalDrawing {
 public:
  explicit IntervalDrawing(const IntervalPlot& plot) : plot_(plot) {
    double x = kColumnGap_px;
    for (std::size_t k = 0; k < plot.table.columns.size(); ++k) {
      if (k + 1 == plot.table.columns.size()) {
        box_ = {x, x + kIntervalWidth_px, kIntervalHead_px,
                kIntervalHead_px + kIntervalRow_px * static_cast<double>(plot.rows.size())};
        x += kIntervalWidth_px + kColumnGap_px;
      }
      const double width_px = column_width_px(k);
      columns_.push_back({x, x + width_px});
      x += width_px + kColumnGap_px;
    }
    size_px_ = {x, box_.bottom + kIntervalFoot_px};
  }

  const Point& size_px() const { return size_px_; }

  void draw(DrawingCanvas& canvas) const {
    const PlotScale scale(plot_.axis, shown_values(), box_.left + 8, box_.right - 8);
    draw_axis_below(canvas, scale, box_, 5);
    figure_text(canvas, {(box_.left + box_.right) / 2, box_.bottom + 29}, title_of(plot_.axis), Align::middle,
                kFigureText_px, ink::kText);
    canvas.page_line({scale.px(plot_.neutral), box_.top}, {scale.px(plot_.neutral), box_.bottom}, ink::kFaintText, 1,
                     kDash_px);
    canvas.page_line({kColumnGap_px / 2, kIntervalHead_px - 4},
                     {size_px_.x() - kColumnGap_px / 2, kIntervalHead_px - 4}, ink::kFaintText, 0.7);
    for (std::size_t k = 0; k < plot_.table.columns.size(); ++k)
      cell(canvas, k, kIntervalHead_px - 10, head_text(plot_.table.columns[k]), ink::kFaintText);
    for (std::size_t row = 0; row < plot_.rows.size(); ++row) draw_row(canvas, scale, row);
  }

 private:
  struct Span {
    double left = 0, right = 0;
  };

  double column_width_px(std::size_t k) const {
    double width_px = figure_text_width_px(head_text(plot_.table.columns[k]), kFigureText_px);
    for (const std::vector<Cell>& row : plot_.table.rows)
      if (k < row.size()) width_px = std::max(width_px, figure_text_width_px(row[k].text, kFigureText_px));
    return width_px;
  }

  std::vector<double> shown_values() const {
    std::vector<double> values{plot_.neutral};
    for (const IntervalPlot::Row& row : plot_.rows) values.insert(values.end(), {row.at, row.low, row.high});
    return values;
  }

  void cell(DrawingCanvas& canvas, std::size_t column, double y_px, const std::string& text, const Color& color) const {
    const bool right = plot_.table.columns[column].number;
    figure_text(canvas, {right ? columns_[column].right : columns_[column].left, y_px}, text,
                right ? Align::end : Align::begin, kFigureText_px, color);
  }

  void draw_row(DrawingCanvas& canvas, const PlotScale& scale, std::size_t number) const {
    const IntervalPlot::Row& row = plot_.rows[number];
    const double y = box_.top + kIntervalRow_px * (static_cast<double>(number) + 0.5);
    if (number < plot_.table.rows.size())
      for (std::size_t k = 0; k < plot_.table.rows[number].size(); ++k)
        cell(canvas, k, y + 4, plot_.table.rows[number][k].text, ink::kText);
    if (std::isnan(row.at) || std::isnan(row.low) || std::isnan(row.high)) return;
    const double at = scale.px(row.at), low = scale.px(row.low), high = scale.px(row.high);
    if (row.total) {
      const double left = std::min(low, at - kLeastDiamond_px), right = std::max(high, at + kLeastDiamond_px);
      canvas.page_polygon(std::array{Point(left, y), Point(at, y - 6), Point(right, y), Point(at, y + 6)},
                          tone_color(row.tone));
      return;
    }
    canvas.page_line({low, y}, {high, y}, ink::kText, 1.3);
    if (row.low < scale.low()) canvas.page_arrow_head({low, y}, std::numbers::pi, 8, ink::kText, ink::kText);
    if (row.high > scale.high()) canvas.page_arrow_head({high, y}, 0, 8, ink::kText, ink::kText);
    canvas.page_rectangle({at - 4, y - 4}, {8, 8}, tone_color(row.tone));
  }

  const IntervalPlot& plot_;
  std::vector<Span> columns_;
  PlotBox box_;
  Point size_px_ = Point::Zero();
};

}  // namespace

void write_figure(const std::string& path, const IntervalPlot& plot) {
  const IntervalDrawing drawing(plot);
  write_vector_files(path, drawing.size_px(), [&](DrawingCanvas& canvas) { drawing.draw(canvas); });
}

}  // namespace opal
