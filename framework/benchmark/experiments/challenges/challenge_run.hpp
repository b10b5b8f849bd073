#pragma once

#include "benchmark/experiments/kit/contender.hpp"
#include "benchmark/experiments/kit/judged_moment.hpp"

#include "simulation/drives/challenges.hpp"

#include <optional>
#include <string>
#include <vector>

namespace opal::experiments {

/// What became of one run: the measures of Hendrikx (2023), 3.5.5. Distances are driven until then; none: never.
struct ChallengeRun {
  std::string contender, challenge;
  std::uint64_t seed = 0;
  std::optional<RegionPrior> region;                    ///< that the robot was told
  bool success = false;                                 ///< the best hypothesis becomes right and stays so to the end
  std::optional<double> right_after_m;                  ///< until it was so
  std::optional<double> localized_after_m;              ///< until the first `localized`
  std::optional<double> error_m;                        ///< of the best hypothesis, mean from there on
  int hypotheses_before = 0, hypotheses_after = 0;      ///< most, before and after the first `localized`
  int updates = 0, localized_rows = 0, false_rows = 0;  ///< `localized` and wrong
  double cpu_ms = 0;                                    ///< per update
  double truth_probability = 0;       ///< at the end, of the hypothesis that is right; 0: there is none
  std::vector<JudgedMoment> moments;  ///< by scan
};

/// Fills in everything but the names from the moments.
void judge(ChallengeRun& run);

ChallengeRun run_challenge(const Contender& contender, const PluginRegistry& registry,
                           std::shared_ptr<const SemanticMap> map, const simulation::ChallengeDrive& driven);

}  // namespace opal::experiments
