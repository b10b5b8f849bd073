#pragma once

#include "benchmark/verdict/paired_sample.hpp"
#include "benchmark/verdict_page/linked_runs.hpp"

namespace opal::statistics {

/// One row per metric: what both arms reach, how far they are apart, and the outcome. What differs comes first.
Table summary_table(const Verdict& verdict);

/// Whether some pair differs: else the metric says nothing beside its values.
bool differs(const MetricResult& result);

/// Every number behind a verdict, one column per metric.
Table numbers_table(const Verdict& verdict);

/// Counts of a proportion's pairs: both, only one, neither.
Table counts_table(const MetricResult& result, const std::string& arm, const std::string& baseline);

/// The pairs that differ, most first, with links to both runs.
Table differing_table(const PairedSample& sample, const Metric& metric, const std::string& arm,
                      const std::string& baseline, const LinkedRuns& links);

/// Runs that did not end well, named.
Table failures_table(const ResultsTable& table, const LinkedRuns& links);

Table versions_table(const std::vector<ReportPage::Version>& versions);

}  // namespace opal::statistics
