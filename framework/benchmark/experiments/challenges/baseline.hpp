#pragma once

#include "benchmark/experiments/challenges/challenge_run.hpp"

#include <opal/common/error.hpp>

namespace opal::experiments {

/// Another localizer: a program that reads a recorded log and a grid map, and writes what it says about each
/// scan (docs/simulate.md). It is never told the truth.
struct Baseline {
  std::string program;  ///< path
  std::string name;     ///< of its column
};

/// Lets it play one challenge. What it needs is written beside `prefix`, and stays there: PREFIX.log.gz,
/// .gt.csv, .info.json, .queries.json; its answer is PREFIX.NAME.csv.
/// @param grid_yaml  the map as map_server has it.
/// @throws Error naming the program and what went wrong: it cannot be started, fails, or leaves a table that
/// is none.
ChallengeRun run_baseline(const Baseline& baseline, const simulation::ChallengeDrive& driven, const std::string& prefix,
                          const std::string& grid_yaml, std::uint64_t seed);

/// Reads `timestamp,x,y,theta,localized,hypotheses,cpu_ms` [s, m, rad]: T_map_laser by scan.
/// @throws LogError naming file and line.
std::vector<JudgedMoment> read_baseline(const std::string& path, const simulation::Recording& recording);

}  // namespace opal::experiments
