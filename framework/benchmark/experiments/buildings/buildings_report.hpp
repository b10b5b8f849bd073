#pragma once

#include "benchmark/experiments/buildings/building_groups.hpp"
#include "report/table.hpp"

#include <nlohmann/json.hpp>

namespace opal::experiments {

/// The whole of an experiment over many buildings.
struct BuildingsExperiment {
  std::vector<BuildingRuns> buildings;
  std::vector<BuildingGroup> groups;
  std::string command;      ///< that runs it again
  std::string run_command;  ///< the same without its choice of buildings and challenges
};

/// A row per contender and group, shares in percent with their 95 % intervals.
Table buildings_table(const BuildingsExperiment& experiment);

/// Groups, buildings and runs. Everything is the same whenever and wherever it is run, but for keys that
/// begin with "cpu_".
nlohmann::ordered_json to_json(const BuildingsExperiment& experiment);

/// The command that runs one challenge in one building alone.
std::string command_for(const BuildingsExperiment& experiment, const BuildingRuns& building, const ChallengeRun& run);

}  // namespace opal::experiments
