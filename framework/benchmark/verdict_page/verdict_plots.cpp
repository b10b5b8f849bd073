#include "benchmark/verdict_page/verdict_plots.hpp"

#include "benchmark/verdict/quantity_words.hpp"
#include "common/phrases.hpp"
#include "report/html_elements.hpp"
#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <array>

namespace opal::statistics {
namespace {

using Kind = Metric::Kind;

constexpr std::size_t kMostPoints = 4000;  // a browser draws that at once

struct ForestRow {
  std::string name;
  std::size_t pairs;
  const Effect& effect;
  Outcome outcome;
};

std::string tone_of(Outcome outcome) {
  constexpr std::array kTones{"good", "bad", "equal", "open"};
  return kTones[static_cast<std::size_t>(outcome)];
}

void add(IntervalPlot& plot, const Metric& metric, const ForestRow& row, bool total) {
  const Effect& effect = row.effect;
  const double at = shown_size(metric, effect.size), low = shown_size(metric, effect.interval.low),
               high = shown_size(metric, effect.interval.high);
  plot.rows.push_back({at, low, high, tone_of(row.outcome), total});
  plot.table.rows.push_back({row.name, std::to_string(row.pairs), value_text(metric, effect.a),
                             value_text(metric, effect.b),
                             within_text(at, low, high, metric.kind == Kind::proportion ? 1 : 2)});
}

std::string point_text(const PairedValue& pair, const Metric& metric, const std::string& arm,
                       const std::string& baseline) {
  return fmt::format("{}, query {}, seed {}: {} {}, {} {}", pair.cluster, pair.query, pair.seed, baseline,
                     value_text(metric, pair.a), arm, value_text(metric, pair.b));
}

/// Of so many pairs, one is drawn.
std::size_t step_of(const PairedSample& sample) { return (sample.pairs.size() + kMostPoints - 1) / kMostPoints; }

}  // namespace

PlotAxis size_axis(const Metric& metric) {
  if (metric.kind == Kind::proportion) return {"difference", "points"};
  if (metric.kind == Kind::cost) return {"ratio", "", true};
  return {"median difference", metric.unit};
}

double shown_size(const Metric& metric, double size) { return metric.kind == Kind::proportion ? 100 * size : size; }

IntervalPlot forest_plot(const MetricResult& result, const std::string& arm, const std::string& baseline) {
  const Metric& metric = result.metric;
  IntervalPlot plot{size_axis(metric), metric.kind == Kind::cost ? 1.0 : 0.0, {}, {}};
  plot.table.columns = {
      {"site", "", false}, {"queries"}, {baseline}, {arm}, {plot.axis.name + " (interval)", plot.axis.unit}};
  for (const ClusterResult& cluster : result.clusters)
    add(plot, metric, {cluster.cluster, cluster.pairs, cluster.effect, cluster.outcome}, false);
  add(plot, metric,
      {result.between_clusters ? "all, from site to site" : "all, these sites only", result.pairs, result.effect,
       result.outcome},
      true);
  return plot;
}

std::string forest_html(const MetricResult& result, const std::string& arm, const std::string& baseline) {
  return plot_html(forest_plot(result, arm, baseline), "differences in " + name_in_words(result.metric) + " per site");
}

ScatterPlot pairs_plot(const PairedSample& sample, const Metric& metric, const std::string& arm,
                       const std::string& baseline, const LinkedRuns& links) {
  const bool cost = metric.kind == Kind::cost;
  const std::string what = ", " + name_in_words(metric);
  ScatterPlot plot{{baseline + what, metric.unit, cost}, {arm + what, metric.unit, cost}, {}};
  const std::size_t step = step_of(sample);
  for (std::size_t i = 0; i < sample.pairs.size(); i += step) {
    const PairedValue& pair = sample.pairs[i];
    const auto link = [&](const std::string& name) { return links.of(name, pair.cluster, pair.query, pair.seed); };
    plot.points.push_back({pair.a, pair.b, point_text(pair, metric, arm, baseline), {}, {link(baseline), link(arm)}});
  }
  return plot;
}

std::string scatter_html(const PairedSample& sample, const Metric& metric, const std::string& arm,
                         const std::string& baseline, const LinkedRuns& links) {
  const std::string html = plot_html(pairs_plot(sample, metric, arm, baseline, links),
                                     arm + " beside " + baseline + ", " + name_in_words(metric));
  const std::size_t step = step_of(sample);
  if (step < 2) return html;
  return html + text_element("p", fmt::format("One in {} of {} is drawn.", step, count_of(sample.pairs.size(), "pair")),
                             "quiet");
}

}  // namespace opal::statistics
