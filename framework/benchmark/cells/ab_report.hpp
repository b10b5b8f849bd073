#pragma once

#include "benchmark/cells/ab_views.hpp"

#include "benchmark/verdict/comparison.hpp"
#include "benchmark/verdict_page/report_page.hpp"

namespace opal::benchmark {

/// The metrics that an experiment is judged by, the one that decides first. @throws opal::ConfigError for an unknown
/// name.
std::vector<opal::statistics::Metric> metrics_of(const opal::ab::Experiment& experiment);

/// Whether a metric of that name is a time or memory, which comes out differently when an experiment is repeated.
bool is_measured(const std::string& metric);

/// Results as the statistics take them; queries that some arm has not finished are left out.
opal::statistics::ResultsTable table_of(const opal::ab::MergedResults& results, const opal::ab::CellPlan& plan);

/// Which look at the results this is, of those that the experiment allows: they are equally far apart, and the last one
/// is at all cells. 0: there is none at so few, and none again at no more than when it was last looked.
int look_at(const opal::ab::Experiment& experiment, const opal::ab::ResultFolder& folder,
            const opal::ab::MergedResults& results, const opal::ab::CellPlan& plan);

/// Says who is better, in words on stdout, and writes verdict.json, report.html and the folder paper.
void report(const opal::ab::Experiment& experiment, const opal::ab::CellPlan& plan,
            const opal::ab::ResultFolder& folder, const opal::ab::MergedResults& results,
            const nlohmann::ordered_json& manifest, int look, const ViewLinks& links);

}  // namespace opal::benchmark
