#pragma once

#include "benchmark/experiments/challenges/challenge_run.hpp"
#include "benchmark/experiments/kit/thesis_table.hpp"

#include <iosfwd>

namespace opal::experiments {

/// The runs in the layout of Hendrikx (2023), table 3.3, beside what it published: a column per challenge, a
/// block of rows per contender; medians over the seeds, and shares of all runs with Wilson's 95 % interval
/// (1927).
ThesisTable challenge_table(std::span<const ChallengeRun> runs);

/// By contender and challenge: the same with intervals, and what was published.
nlohmann::ordered_json challenge_summary(std::span<const ChallengeRun> runs);

/// One row per run.
void write_runs(std::ostream& out, std::span<const ChallengeRun> runs);

/// A page with the table, the ways in the building as in figure 3.9, and the runs of the first seed over time
/// as in figure 3.10.
std::string challenge_page(const SemanticMap& map, std::span<const ChallengeRun> runs);

}  // namespace opal::experiments
