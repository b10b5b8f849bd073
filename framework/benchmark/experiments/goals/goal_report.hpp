#pragma once

#include "benchmark/experiments/goals/goal_run.hpp"
#include "benchmark/experiments/kit/thesis_table.hpp"

#include <nlohmann/json.hpp>

#include <iosfwd>
#include <span>

namespace opal::experiments {

/// The runs in the layout of Hendrikx (2023), table 4.1, beside what it published: a column per route and set
/// of patterns, a block of rows per contender; medians over the seeds (a drive that does not arrive takes for
/// ever), and shares of all runs with Wilson's 95 % interval (1927).
ThesisTable goal_table(std::span<const GoalRun> runs);

/// By contender and task: the same with intervals, and the published total time.
nlohmann::ordered_json goal_summary(std::span<const GoalRun> runs);

/// One row per run.
void write_runs(std::ostream& out, std::span<const GoalRun> runs);

/// A page with the table, the ways in the building as in figure 4.10, and the runs of the first seed over
/// time.
std::string goal_page(const SemanticMap& map, std::span<const GoalRun> runs);

}  // namespace opal::experiments
