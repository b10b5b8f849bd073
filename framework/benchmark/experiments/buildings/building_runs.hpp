#pragma once

#include "benchmark/experiments/challenges/challenge_run.hpp"

#include "simulation/drives/building_suite.hpp"

namespace opal::experiments {

/// How a run ended, from best to worst.
enum class Outcome {
  localized,  ///< the best hypothesis is right up to the end, and was called localized
  unsure,     ///< it is right up to the end, and never was
  unknown,    ///< it is not right at the end, and no wrong one was called localized: honest, as it must be where
              ///< places are alike
  wrong       ///< a wrong pose was called localized at some time
};
const char* name_of(Outcome outcome);
Outcome outcome_of(const ChallengeRun& run);
/// Since the start until the first pose that was called localized, and until the first that was so wrongly [s];
/// kNever.
double localized_after_s(const ChallengeRun& run);
double wrong_after_s(const ChallengeRun& run);

/// What became of all challenges in one building.
struct BuildingRuns {
  simulation::SuiteBuilding building;
  std::shared_ptr<const SemanticMap> map;
  std::vector<ChallengeRun> runs;  ///< by challenge, then seed, then contender
  double cpu_s = 0;                ///< of everything: building, driving, localizing
};

struct BuildingsOptions {
  std::vector<Contender> contenders;
  std::vector<std::string> challenges;  ///< ids; empty: all
  int seeds = 1;                        ///< runs per challenge: clutter, people and noise differ
  double duration_s = 60;
  std::string recordings;  ///< folder for recordings of all runs, as opal bench takes them; empty: none
};

BuildingRuns run_building(const simulation::SuiteBuilding& building, const PluginRegistry& registry,
                          const BuildingsOptions& options);

}  // namespace opal::experiments
