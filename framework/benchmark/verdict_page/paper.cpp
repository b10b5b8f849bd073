#include "benchmark/verdict_page/paper.hpp"

#include "benchmark/verdict_page/report_tables.hpp"
#include "benchmark/verdict_page/verdict_plots.hpp"
#include "common/whole_file.hpp"
#include "drawing/figure.hpp"
#include "report/table_files.hpp"

namespace opal::statistics {
namespace {

void write_metric(const ReportPage& page, const Verdict& verdict, const MetricResult& result,
                  const std::string& prefix) {
  const LinkedRuns no_links{ReportPage{}};
  const IntervalPlot sites = forest_plot(result, verdict.arm, verdict.baseline);
  write_table(prefix + "_sites", sites.table);
  write_figure(prefix + "_sites", sites);
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
