#pragma once

#include "benchmark/cells/ab_runner.hpp"

#include "benchmark/ab/records/merged_results.hpp"

#include "benchmark/verdict/results_table.hpp"

namespace opal::benchmark {

/// Where the run behind a row is shown, relative to the results; empty if nowhere.
using ViewLinks = std::function<std::string(const opal::statistics::ResultRow&)>;

/// Runs the queries in which an arm and the baseline are farthest apart once more, both arms, and writes a page of
/// `opal view` with the two side by side: views/NAME.html, a few for each arm. Links lead to the moment at which the
/// one that is right sooner has just become so.
ViewLinks write_views(const opal::ab::Experiment& experiment, const opal::ab::CellPlan& plan,
                      const opal::ab::ResultFolder& folder, const opal::ab::MergedResults& results,
                      LocalizingRunner& runner);

}  // namespace opal::benchmark
