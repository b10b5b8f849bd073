#pragma once

#include "benchmark/verdict/paired_sample.hpp"
#include "benchmark/verdict_page/linked_runs.hpp"

namespace opal::statistics {

/// SVG: each pair of a distance or a cost as a dot, the baseline to the right, the other arm upwards; what was never
/// reached lies beyond the dashed lines. The left half of a dot is a link to the baseline's run, the right half to the
/// other arm's.
std::string scatter_plot(const PairedSample& sample, const Metric& metric, const std::string& arm,
                         const std::string& baseline, const LinkedRuns& links);

}  // namespace opal::statistics
