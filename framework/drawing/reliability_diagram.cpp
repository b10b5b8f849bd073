#include "drawing/reliability_diagram.hpp"

#include <opal/common/sentence.hpp>

#include "drawing/drawing_layers.hpp"
#include "drawing/picture_file.hpp"

#include <algorithm>
#include <cmath>

namespace opal {
namespace {

constexpr double kPanel_px = 380, kBars_px = 90, kGap_px = 34, kDiagramText_px = 13;
constexpr double kLeft_px = 64, kTop_px = 84, kBetween_px = 92, kRight_px = 40, kBelow_px = 96;
const Point kPage_px(kLeft_px + 2 * kPanel_px + kBetween_px + kRight_px,
                     kTop_px + kPanel_px + kGap_px + kBars_px + kBelow_px);

/// One pair of axes: what was said to the right, what came true upwards, and below how often.
class Panel {
 public:
  Panel(DrawingCanvas& canvas, const Point& corner_px, double said_from, double true_from)
      : canvas_(canvas), corner_px_(corner_px), from_(said_from, true_from) {}

  void draw(const std::vector<ReliabilityBin>& bins) {
    canvas_.page_rectangle(corner_px_, {kPanel_px, kPanel_px}, ink::kPlot);
    canvas_.page_rectangle(corner_px_ + Point(0, kPanel_px + kGap_px), {kPanel_px, kBars_px}, ink::kPlot);
    draw_grid();
    const double start = std::max(from_.x(), from_.y());
    canvas_.page_line(at(start, start), at(1, 1), ink::kTruth, kTruth_px, kDash_px);
    std::size_t most = 1;
    for (const ReliabilityBin& bin : bins) most = std::max(most, bin.statements);
    for (const ReliabilityBin& bin : bins)
      if (bin.from >= from_.x() - 1e-9) draw_bin(bin, most);
  }

 private:
  Point at(double said, double came_true) const {
    return corner_px_ +
           Point(kPanel_px * (said - from_.x()) / (1 - from_.x()), kPanel_px * (1 - came_true) / (1 - from_.y()));
  }

  void draw_grid() {
    constexpr int kTicks = 5;
    for (int k = 0; k <= kTicks; ++k) {
      const double share = static_cast<double>(k) / kTicks;
      const double said = from_.x() + share * (1 - from_.x()), came_true = from_.y() + share * (1 - from_.y());
      canvas_.page_line(at(said, 1), at(said, from_.y()), ink::kGrid, 1);
      canvas_.page_line(at(from_.x(), came_true), at(1, came_true), ink::kGrid, 1);
      const std::string x = sentence("%.2f", said), y = sentence("%.2f", came_true);
      canvas_.text(at(said, from_.y()) + Point(-canvas_.text_width_px(x, kDiagramText_px) / 2, 20), x, kDiagramText_px,
                   ink::kFaintText);
      canvas_.text(at(from_.x(), came_true) + Point(-canvas_.text_width_px(y, kDiagramText_px) - 8, 4), y,
                   kDiagramText_px, ink::kFaintText);
    }
  }

  void draw_bin(const ReliabilityBin& bin, std::size_t most) {
    const auto inside = [&](double came_true) { return std::max(came_true, from_.y()); };
    const double low = inside(bin.came_true_within.low), high = inside(bin.came_true_within.high);
    canvas_.page_line(at(bin.said, low), at(bin.said, high), ink::kLocalFeature.with_opacity(0.45), 3);
    canvas_.page_disc(at(bin.said, inside(bin.came_true)), 5, ink::kLocalFeature, ink::kPlot);
    const double height_px =
        kBars_px * std::log1p(static_cast<double>(bin.statements)) / std::log1p(static_cast<double>(most));
    const Point left = at(bin.from, 0), right = at(bin.to, 0);
    const double base_px = corner_px_.y() + kPanel_px + kGap_px + kBars_px,
                 width_px = std::max(2.0, right.x() - left.x() - 2);
    const double left_px = std::min(left.x() + 1, right.x() - width_px);
    canvas_.page_rectangle({left_px, base_px - height_px}, {width_px, height_px},
                           ink::kLocalFeature.with_opacity(0.35));
    const std::string count = std::to_string(bin.statements);
    const double text_px = canvas_.text_width_px(count, 10);
    if (text_px < width_px) canvas_.text({left_px + (width_px - text_px) / 2, base_px - 4}, count, 10, ink::kText);
  }

  DrawingCanvas& canvas_;
  Point corner_px_;
  Point from_;  ///< least said and least come true that are shown
};

/// Where the axis of what came true has to begin, to show everything that was said from here on.
double lowest_from(const std::vector<ReliabilityBin>& bins, double said_from) {
  double lowest = said_from;
  for (const ReliabilityBin& bin : bins)
    if (bin.from >= said_from - 1e-9) lowest = std::min(lowest, bin.came_true_within.low);
  return std::floor(lowest * 10) / 10;
}

void draw(const Calibration& calibration, const std::string& title, cairo_surface_t* surface) {
  constexpr double kClose = 0.9;
  DrawingCanvas canvas(surface, {});
  canvas.page_rectangle(Point::Zero(), kPage_px, ink::kPaper);
  canvas.text({kLeft_px, 36}, title, 18, ink::kText, true);
  const std::string scores =
      sentence("%zu statements in %zu queries; Brier score %.4f, log loss %.3f nat, expected calibration error %.4f",
               calibration.statements, calibration.clusters, calibration.brier, calibration.log_loss,
               calibration.expected_error);
  canvas.text({kLeft_px, 60}, scores, kDiagramText_px, ink::kFaintText);
  Panel(canvas, {kLeft_px, kTop_px}, 0, 0).draw(calibration.bins);
  Panel(canvas, {kLeft_px + kPanel_px + kBetween_px, kTop_px}, kClose, lowest_from(calibration.bins, kClose))
      .draw(calibration.bins);
  const double below_px = kPage_px.y() - kBelow_px;
  canvas.text({kLeft_px, below_px + 28},
              "Right: what was said (probability). Up: what came true (share), with 95 % by the number of queries.",
              kDiagramText_px, ink::kText);
  canvas.text({kLeft_px, below_px + 48}, "Dashed: perfectly calibrated. The second panel shows the same from 0.9 on.",
              kDiagramText_px, ink::kText);
  canvas.text({kLeft_px, below_px + 68}, "Bars: statements per bin, on a logarithmic scale.", kDiagramText_px,
              ink::kText);
}

}  // namespace

void write_reliability_svg(const Calibration& calibration, const std::string& title, const std::string& path) {
  write_svg_picture(path, kPage_px, [&](cairo_surface_t* surface) { draw(calibration, title, surface); });
}

void write_reliability_png(const Calibration& calibration, const std::string& title, const std::string& path) {
  write_png_picture(path, kPage_px, [&](cairo_surface_t* surface) { draw(calibration, title, surface); });
}

}  // namespace opal
