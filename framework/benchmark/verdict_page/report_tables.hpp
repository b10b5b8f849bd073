#pragma once

#include "benchmark/verdict/paired_sample.hpp"
#include "benchmark/verdict_page/linked_runs.hpp"

namespace opal::statistics {

/// HTML tables of a report page.

/// Every number behind a verdict, one column per metric.
std::string numbers_table(const Verdict& verdict);

/// Counts of a proportion's pairs: both, only one, neither.
std::string counts_table(const MetricResult& result, const std::string& arm, const std::string& baseline);

/// The pairs that differ, most first, with links to both runs; at most so many, and says how many are not shown.
std::string differing_table(const PairedSample& sample, const Metric& metric, const std::string& arm,
                            const std::string& baseline, const LinkedRuns& links);

/// What costs what: medians and ratio per cluster.
std::string cost_table(const MetricResult& result, const std::string& arm, const std::string& baseline);

/// Runs that did not end well, named; at most so many, and says how many are not shown.
std::string failures_table(const ResultsTable& table, const LinkedRuns& links);

std::string versions_table(const std::vector<ReportPage::Version>& versions);

}  // namespace opal::statistics
