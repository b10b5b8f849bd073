#pragma once

#include "benchmark/verdict/paired_sample.hpp"
#include "benchmark/verdict_page/linked_runs.hpp"

namespace opal::statistics {

/// One row per cluster with its difference and interval, and all together at the bottom. Shares in points, costs as
/// ratios on a logarithmic axis.
IntervalPlot forest_plot(const MetricResult& result, const std::string& arm, const std::string& baseline);
/// The same as HTML.
std::string forest_html(const MetricResult& result, const std::string& arm, const std::string& baseline);

/// Each pair of a distance or a cost as a point, the baseline to the right, the other arm upwards. Its left half is a
/// link to the baseline's run, its right half to the other arm's. Of very many, some.
ScatterPlot pairs_plot(const PairedSample& sample, const Metric& metric, const std::string& arm,
                       const std::string& baseline, const LinkedRuns& links);
/// The same as HTML, which says how many are drawn.
std::string scatter_html(const PairedSample& sample, const Metric& metric, const std::string& arm,
                         const std::string& baseline, const LinkedRuns& links);

/// What the size of an effect is called: "difference [points]", "ratio".
PlotAxis size_axis(const Metric& metric);

/// A size as that axis has it: a share in points.
double shown_size(const Metric& metric, double size);

}  // namespace opal::statistics
