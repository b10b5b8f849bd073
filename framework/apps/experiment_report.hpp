#pragma once

#include "experiment_runs.hpp"

#include <iosfwd>
#include <span>

/// The runs of an experiment in the layout of Hendrikx (2023), table 3.3: a column per challenge, a block of rows per
/// contender; medians over the seeds, and shares of all runs with Wilson's 95 % interval (1927).
std::string experiment_table(std::span<const ExperimentRun> runs);

/// One row per run.
void write_runs(std::ostream& out, std::span<const ExperimentRun> runs);

/// A page with the table and a picture of the building with all ways. @throws opal::Error naming the file.
void write_experiment_page(const std::string& path, const std::string& title, const std::string& table,
                           const opal::SemanticMap& map, std::span<const ExperimentRun> runs);
