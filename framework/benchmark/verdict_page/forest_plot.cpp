#include "benchmark/verdict_page/forest_plot.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "benchmark/verdict_page/plot_scale.hpp"
#include "report/html_text.hpp"
#include "report/quantity_text.hpp"

#include <algorithm>
#include <cmath>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

constexpr double kRow_px = 24, kTop_px = 44, kPlotFrom_px = 410, kPlotTo_px = 800, kWidth_px = 980;

double shown(Kind kind, double size) { return kind == Kind::proportion ? 100 * size : size; }

std::string text_at(double x, double y, const std::string& text, const std::string& more = "") {
  return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\"" + more + ">" + html_text(text) + "</text>";
}

double neutral(Kind kind) { return kind == Kind::cost ? 1 : 0; }

/// Finite ends and sizes of all rows; at least a little beside no difference.
PlotScale scale_of(const MetricResult& result) {
  const Kind kind = result.metric.kind;
  double low = neutral(kind), high = low;
  const auto include = [&](double size) {
    if (!std::isfinite(size) || (kind == Kind::cost && size <= 0)) return;
    low = std::min(low, shown(kind, size));
    high = std::max(high, shown(kind, size));
  };
  const auto include_effect = [&](const Effect& effect) {
    for (const double size : {effect.size, effect.interval.low, effect.interval.high}) include(size);
  };
  include_effect(result.effect);
  for (const ClusterResult& cluster : result.clusters) include_effect(cluster.effect);
  if (kind == Kind::cost) return {low / 1.05, high * 1.05, kPlotFrom_px, kPlotTo_px, true};
  const double room = 0.05 * std::max(high - low, 1e-6);
  return {low - room, high + room, kPlotFrom_px, kPlotTo_px};
}

std::string grid(const PlotScale& scale, Kind kind, double bottom) {
  std::string svg;
  for (const double tick : scale.ticks()) {
    svg += line(scale.place_px(tick), kTop_px - 8, scale.place_px(tick), bottom, "grid");
    svg += text_at(scale.place_px(tick), bottom + 16, tick_text(tick), " class=\"middle quiet\"");
  }
  return svg + line(scale.place_px(neutral(kind)), kTop_px - 8, scale.place_px(neutral(kind)), bottom, "none");
}

/// An end beyond the plot, or without bounds, is an arrow.
std::string whisker(const PlotScale& scale, Kind kind, const Interval& interval, double y) {
  const double low = shown(kind, interval.low), high = shown(kind, interval.high);
  const double from = scale.place_px(low), to = scale.place_px(high);
  std::string svg = line(from, y, to, y, "whisker");
  if (!scale.holds(low)) svg += "<path class=\"arrow\" d=\"M" + px(from) + " " + px(y) + "l7 -4v8z\"/>";
  if (!scale.holds(high)) svg += "<path class=\"arrow\" d=\"M" + px(to) + " " + px(y) + "l-7 -4v8z\"/>";
  return svg;
}

std::string square(double x, double y, double half, const std::string& outcome) {
  return "<rect class=\"" + outcome + "\" x=\"" + px(x - half) + "\" y=\"" + px(y - half) + "\" width=\"" +
         px(2 * half) + "\" height=\"" + px(2 * half) + "\"/>";
}

std::string diamond(const PlotScale& scale, Kind kind, const Effect& effect, double y, const std::string& outcome) {
  const double x = scale.place_px(shown(kind, effect.size));
  return "<path class=\"" + outcome + "\" d=\"M" + px(scale.place_px(shown(kind, effect.interval.low))) + " " + px(y) +
         "L" + px(x) + " " + px(y - 7) + "L" + px(scale.place_px(shown(kind, effect.interval.high))) + " " + px(y) +
         "L" + px(x) + " " + px(y + 7) + "z\"/>";
}

std::string size_number(const MetricResult& result, const Effect& effect) {
  const Kind kind = result.metric.kind;
  const int decimals = kind == Kind::proportion ? 1 : 2;
  const auto number = [&](double size) {
    return std::isinf(size) ? (size < 0 ? "-∞" : "∞") : fixed_text(shown(kind, size), decimals);
  };
  return number(effect.size) + " (" + number(effect.interval.low) + " to " + number(effect.interval.high) + ")";
}

std::string row_text(const MetricResult& result, const std::string& name, std::size_t pairs, const Effect& effect,
                     double y) {
  return text_at(0, y + 4, name) + text_at(230, y + 4, std::to_string(pairs), " class=\"end\"") +
         text_at(315, y + 4, value_text(result.metric, effect.a), " class=\"end\"") +
         text_at(395, y + 4, value_text(result.metric, effect.b), " class=\"end\"") +
         text_at(815, y + 4, size_number(result, effect));
}

std::string head(const MetricResult& result, const std::string& arm, const std::string& baseline) {
  const Kind kind = result.metric.kind;
  const std::string size = kind == Kind::proportion ? "difference, points"
                           : kind == Kind::cost     ? "ratio"
                                                    : "median difference, " + result.metric.unit;
  return text_at(0, 20, "site", " class=\"quiet\"") + text_at(230, 20, "queries", " class=\"end quiet\"") +
         text_at(315, 20, baseline, " class=\"end quiet\"") + text_at(395, 20, arm, " class=\"end quiet\"") +
         text_at(815, 20, size, " class=\"quiet\"");
}

std::string name_of(Outcome outcome) {
  return outcome == Outcome::better  ? "better"
         : outcome == Outcome::worse ? "worse"
         : outcome == Outcome::equal ? "equal"
                                     : "open";
}

}  // namespace

std::string forest_plot(const MetricResult& result, const std::string& arm, const std::string& baseline) {
  const Kind kind = result.metric.kind;
  const PlotScale scale = scale_of(result);
  const double bottom = kTop_px + kRow_px * static_cast<double>(result.clusters.size() + 1);
  std::string svg = "<svg class=\"forest\" viewBox=\"0 0 " + px(kWidth_px) + " " + px(bottom + 24) +
                    "\" role=\"img\" aria-label=\"" +
                    html_text("differences in " + name_in_words(result.metric) + " per site") + "\">" +
                    head(result, arm, baseline) + grid(scale, kind, bottom);
  double y = kTop_px;
  for (const ClusterResult& cluster : result.clusters) {
    svg += row_text(result, cluster.cluster, cluster.pairs, cluster.effect, y) +
           whisker(scale, kind, cluster.effect.interval, y) +
           square(scale.place_px(shown(kind, cluster.effect.size)), y, 4.5, name_of(cluster.outcome));
    y += kRow_px;
  }
  svg += "<g class=\"total\">" +
         row_text(result, result.between_clusters ? "all, from site to site" : "all, these sites only", result.pairs,
                  result.effect, y) +
         "</g>" + diamond(scale, kind, result.effect, y, name_of(result.outcome));
  return svg + "</svg>\n";
}

}  // namespace opal::statistics
