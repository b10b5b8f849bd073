#include "drawing/drawing_layers.hpp"
#include "drawing/figure.hpp"
#include "drawing/figure_frame.hpp"

#include <cmath>
#include <map>

namespace opal {
namespace {

const Point kScatterSize_px(420, 418);
constexpr double kNotes_px = 28;  // two lines
constexpr double kLane_px = 44;   // what is infinite lies there

/// Where equal points lie beside each other: a spiral (Vogel 1979).
class Spiral {
 public:
  Point beside(const Point& at_px) {
    constexpr double kGoldenAngle_rad = 2.399963, kApart_px = 3.4, kCell_px = 3;
    const int index = taken_[{std::lround(at_px.x() / kCell_px), std::lround(at_px.y() / kCell_px)}]++;
    const double radius_px = kApart_px * std::sqrt(index), turn_rad = kGoldenAngle_rad * index;
    return at_px + radius_px * Point(std::cos(turn_rad), std::sin(turn_rad));
  }

 private:
  std::map<std::pair<long, long>, int> taken_;
};

/// A scatter plot on its way to the page.
class ScatterDrawing {
 public:
  explicit ScatterDrawing(const ScatterPlot& plot)
      : plot_(plot),
        lane_px_(beyond() ? kLane_px : 0),
        x_(plot.across, values(true), box_.left, box_.right - lane_px_),
        y_(plot.upwards, values(false), box_.bottom, box_.top + lane_px_) {}

  void draw(DrawingCanvas& canvas) const {
    draw_axis_below(canvas, x_, box_, 5);
    draw_axis_left(canvas, y_, box_, 6);
    figure_text(canvas, {(box_.left + box_.right) / 2, box_.bottom + 34}, title_of(plot_.across), Align::middle,
                kFigureText_px, ink::kText);
    figure_text(canvas, {4, 14}, title_of(plot_.upwards), Align::begin, kFigureText_px, ink::kText);
    if (lane_px_ > 0) draw_lanes(canvas);
    if (plot_.diagonal) draw_diagonal(canvas);
    const bool spread = draw_points(canvas);
    double y = kScatterSize_px.y() - kNotes_px + 8;
    const auto note = [&](const std::string& text) {
      figure_text(canvas, {box_.left, y}, text, Align::begin, kFigureTick_px, ink::kFaintText);
      y += kNotes_px / 2;
    };
    if (spread) note("Points of one place lie around it, side by side.");
    if (lane_px_ > 0) note("Beyond the red lines is \"" + plot_.beyond + "\", without a scale.");
  }

 private:
  bool beyond() const {
    for (const ScatterPlot::Point& point : plot_.points)
      if (std::isinf(point.x) || std::isinf(point.y)) return true;
    return false;
  }

  /// What an axis shows: both, if they shall be compared along the diagonal.
  std::vector<double> values(bool across) const {
    const bool both = plot_.diagonal && !plot_.across.from;
    std::vector<double> all;
    for (const ScatterPlot::Point& point : plot_.points) {
      if (across || both) all.push_back(point.x);
      if (across && !both) continue;
      all.push_back(point.y);
      if (point.within) all.insert(all.end(), point.within->begin(), point.within->end());
    }
    return all;
  }

  void draw_lanes(DrawingCanvas& canvas) const {
    const Color color = tone_color("bad");
    const double x = box_.right - lane_px_, y = box_.top + lane_px_;
    canvas.page_line({x, box_.top}, {x, box_.bottom}, color, 1, 3);
    canvas.page_line({box_.left, y}, {box_.right, y}, color, 1, 3);
    figure_text(canvas, {box_.right - lane_px_ / 2, box_.bottom + 14}, plot_.beyond, Align::middle, kFigureTick_px,
                ink::kFaintText);
    figure_text(canvas, {box_.left - 6, box_.top + lane_px_ / 2 + 4}, plot_.beyond, Align::end, kFigureTick_px,
                ink::kFaintText);
  }

  void draw_diagonal(DrawingCanvas& canvas) const {
    const double from = std::max(x_.low(), y_.low()), to = std::min(x_.high(), y_.high());
    if (from < to) canvas.page_line({x_.px(from), y_.px(from)}, {x_.px(to), y_.px(to)}, ink::kFaintText, 1, kDash_px);
  }

  /// @return whether points had to be spread.
  bool draw_points(DrawingCanvas& canvas) const {
    constexpr double kRadius_px = 3.5;
    bool spread = false;
    const Color fill = tone_color("a");
    Spiral spiral;
    for (const ScatterPlot::Point& point : plot_.points) {
      if (std::isnan(point.x) || std::isnan(point.y)) continue;
      const Point at(std::isinf(point.x) ? box_.right - lane_px_ / 2 : x_.px(point.x),
                     std::isinf(point.y) ? box_.top + lane_px_ / 2 : y_.px(point.y));
      if (point.within)
        canvas.page_line({at.x(), y_.px((*point.within)[0])}, {at.x(), y_.px((*point.within)[1])}, ink::kText, 1.5);
      const Point beside = point.within ? at : spiral.beside(at);
      spread = spread || beside != at;
      canvas.page_disc(beside, kRadius_px, fill.with_opacity(0.7), ink::kPlot);
    }
    return spread;
  }

  const ScatterPlot& plot_;
  PlotBox box_{62, kScatterSize_px.x() - 12, 24, kScatterSize_px.y() - 44 - kNotes_px};
  double lane_px_;
  PlotScale x_, y_;
};

}  // namespace

void write_figure(const std::string& path, const ScatterPlot& plot) {
  write_vector_files(path, kScatterSize_px, [&](DrawingCanvas& canvas) { ScatterDrawing(plot).draw(canvas); });
}

}  // namespace opal
