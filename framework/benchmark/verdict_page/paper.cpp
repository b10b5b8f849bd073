#include "benchmark/verdict_page/paper.hpp"

#include "benchmark/verdict_page/report_tables.hpp"
#include "benchmark/verdict_page/verdict_plots.hpp"
#include "common/whole_file.hpp"
#include "drawing/figure.hpp"
#include "report/table_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace opal::statistics {
namespace {

/// Without the rows whose interval has no bounds; how many they are is said in the last line.
IntervalPlot with_bounds(const IntervalPlot& all) {
  IntervalPlot plot{all.axis, all.neutral, all.table, {}};
  plot.table.rows.clear();
  for (std::size_t k = 0; k < all.rows.size(); ++k) {
    const bool bounded = std::isfinite(all.rows[k].low) || std::isfinite(all.rows[k].high);
    if (!bounded) continue;
    plot.rows.push_back(all.rows[k]);
    plot.table.rows.push_back(all.table.rows[k]);
  }
  const std::size_t left_out = all.rows.size() - plot.rows.size();
  if (left_out == 0 || plot.rows.empty()) return plot;
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  plot.rows.push_back({kNothing, kNothing, kNothing});
  plot.table.rows.push_back({fmt::format("without bounds, not shown: {}", left_out)});
  return plot;
}

void write_metric(const ReportPage& page, const Verdict& verdict, const MetricResult& result,
                  const std::string& prefix) {
  const LinkedRuns no_links{ReportPage{}};
  const IntervalPlot sites = forest_plot(result, verdict.arm, verdict.baseline);
  write_table(prefix + "_sites", sites.table);
  if (const IntervalPlot plot = with_bounds(sites); !plot.rows.empty()) write_figure(prefix + "_sites", plot);
  const PairedSample sample = pair_rows(page.table, result.metric, verdict.baseline, verdict.arm);
  write_table(prefix + "_pairs", differing_table(sample, result.metric, verdict.arm, verdict.baseline, no_links));
  if (result.metric.kind != Metric::Kind::proportion)
    write_figure(prefix + "_pairs", pairs_plot(sample, result.metric, verdict.arm, verdict.baseline, no_links));
}

}  // namespace

void write_paper(const ReportPage& page, const std::string& folder) {
  make_folder(folder);
  for (const Verdict& verdict : page.verdicts) {
    const std::string prefix = folder + "/" + verdict.arm + "_" + verdict.baseline;
    write_table(prefix, summary_table(verdict));
    write_table(prefix + "_numbers", numbers_table(verdict));
    for (const MetricResult& result : verdict.metrics)
      if (differs(result)) write_metric(page, verdict, result, prefix + "_" + result.metric.name);
  }
}

}  // namespace opal::statistics
