#include "benchmark/verdict_page/scatter_plot.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "benchmark/verdict_page/plot_scale.hpp"
#include "report/html_text.hpp"

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

constexpr double kLeft_px = 64, kRight_px = 460, kFrameTop_px = 14, kFrameBottom_px = 410, kLane_px = 44,
                 kRadius_px = 4;
constexpr std::size_t kMostDots = 4000;  // a browser draws that at once

/// Finite values go to the scales, the others to a lane beyond.
struct Axes {
  PlotScale across, upwards;
  bool never;

  double x(double value) const { return std::isfinite(value) ? across.place_px(value) : kRight_px - kLane_px / 2; }
  double y(double value) const { return std::isfinite(value) ? upwards.place_px(value) : kFrameTop_px + kLane_px / 2; }
};

Axes axes_of(const PairedSample& sample, const Metric& metric) {
  const bool cost = metric.kind == Metric::Kind::cost;
  std::vector<double> finite;
  bool never = false;
  for (const PairedValue& pair : sample.pairs)
    for (const double value : {pair.a, pair.b}) {
      if (std::isfinite(value))
        finite.push_back(value);
      else
        never = true;
    }
  if (finite.empty()) finite.push_back(1);
  const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
  const double from = cost ? *low / 1.1 : std::min(0.0, *low), to = cost ? *high * 1.1 : *high * 1.04;
  const double lane = never ? kLane_px : 0, margin = cost ? 0 : 26;  // zeros lie not on the frame
  return {PlotScale(from, to, kLeft_px + margin, kRight_px - lane, cost),
          PlotScale(from, to, kFrameBottom_px - margin, kFrameTop_px + lane, cost), never};
}

std::string label(double x, double y, const std::string& text, const std::string& kind) {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\" class=\"" + kind + "\">" + html_text(text) + "</text>";
}

std::string frame(const Axes& axes) {
  std::string svg = "<rect class=\"frame\" x=\"" + px(kLeft_px) + "\" y=\"" + px(kFrameTop_px) + "\" width=\"" +
                    px(kRight_px - kLeft_px) + "\" height=\"" + px(kFrameBottom_px - kFrameTop_px) + "\"/>";
  for (const double tick : axes.across.ticks()) {
    svg += line(axes.x(tick), kFrameTop_px, axes.x(tick), kFrameBottom_px, "grid") +
           line(kLeft_px, axes.y(tick), kRight_px, axes.y(tick), "grid");
    svg += label(axes.x(tick), kFrameBottom_px + 16, tick_text(tick), "middle quiet") +
           label(kLeft_px - 6, axes.y(tick) + 4, tick_text(tick), "end quiet");
  }
  if (!axes.never) return svg;
  const double x = kRight_px - kLane_px, y = kFrameTop_px + kLane_px;
  svg += line(x, kFrameTop_px, x, kFrameBottom_px, "never") + line(kLeft_px, y, kRight_px, y, "never");
  return svg + label(kRight_px - kLane_px / 2, kFrameBottom_px + 16, "never", "middle quiet") +
         label(kLeft_px - 6, kFrameTop_px + kLane_px / 2 + 4, "never", "end quiet");
}

/// Equal dots lie beside each other, in a spiral (Vogel 1979).
struct Spiral {
  std::map<std::pair<int, int>, int> taken;

  std::pair<double, double> place(double x, double y) {
    constexpr double kGoldenAngle = 2.399963;
    const int index = taken[{static_cast<int>(std::lround(x / 3)), static_cast<int>(std::lround(y / 3))}]++;
    const double radius = 3.4 * std::sqrt(index);
    return {x + radius * std::cos(kGoldenAngle * index), y + radius * std::sin(kGoldenAngle * index)};
  }
};

std::string half(double x, double y, bool left, const std::string& title) {
  const std::string r = px(kRadius_px);
  return "<path class=\"" + std::string(left ? "of-a" : "of-b") + "\" d=\"M" + px(x) + " " + px(y - kRadius_px) + "a" +
         r + " " + r + " 0 0 " + (left ? "0" : "1") + " 0 " + px(2 * kRadius_px) + "z\"><title>" + html_text(title) +
         "</title></path>";
}

std::string dot(const PairedValue& pair, const Metric& metric, std::pair<double, double> place, const std::string& arm,
                const std::string& baseline, const LinkedRuns& links) {
  const std::string what = pair.cluster + ", query " + pair.query + ", seed " + std::to_string(pair.seed) + ": " +
                           baseline + " " + value_text(metric, pair.a) + ", " + arm + " " + value_text(metric, pair.b);
  return linked(links.of(baseline, pair.cluster, pair.query, pair.seed),
                half(place.first, place.second, true, what + " (see " + baseline + ")")) +
         linked(links.of(arm, pair.cluster, pair.query, pair.seed),
                half(place.first, place.second, false, what + " (see " + arm + ")"));
}

std::string axis_names(const Metric& metric, const std::string& arm, const std::string& baseline) {
  const std::string unit = metric.unit.empty() ? "" : " [" + metric.unit + "]",
                    name = ", " + name_in_words(metric) + unit;
  const double middle = (kFrameTop_px + kFrameBottom_px) / 2;
  return label((kLeft_px + kRight_px) / 2, kFrameBottom_px + 36, baseline + name, "middle") +
         "<g transform=\"rotate(-90 16 " + px(middle) + ")\">" + label(16, middle, arm + name, "middle") + "</g>";
}

}  // namespace

std::string scatter_plot(const PairedSample& sample, const Metric& metric, const std::string& arm,
                         const std::string& baseline, const LinkedRuns& links) {
  const Axes axes = axes_of(sample, metric);
  std::string svg = "<svg class=\"scatter\" viewBox=\"0 0 474 456\">" + frame(axes) +
                    line(axes.across.place_px(-1e300), axes.upwards.place_px(-1e300), axes.across.place_px(1e300),
                         axes.upwards.place_px(1e300), "none");
  const std::size_t step = (sample.pairs.size() + kMostDots - 1) / kMostDots;
  Spiral spiral;
  for (std::size_t i = 0; i < sample.pairs.size(); i += step)
    svg += dot(sample.pairs[i], metric, spiral.place(axes.x(sample.pairs[i].a), axes.y(sample.pairs[i].b)), arm,
               baseline, links);
  svg += axis_names(metric, arm, baseline) + "</svg>\n";
  return step < 2 ? svg
                  : svg + "<p class=\"quiet\">One in " + std::to_string(step) + " of " +
                        std::to_string(sample.pairs.size()) + " pairs is drawn.</p>\n";
}

}  // namespace opal::statistics
