#pragma once

#include <opal/deployment.hpp>
#include <opal/replay.hpp>

#include <simulation/challenges.hpp>

#include <string>
#include <vector>

/// One way to localize that takes part in an experiment.
struct Contender {
  std::string name;  ///< of its configuration
  opal::Deployment deployment;
};

/// What became of one run: the measures of Hendrikx (2023), 3.5.5. Distances are driven until then; negative: never.
struct ExperimentRun {
  std::string contender, challenge;
  std::uint64_t seed = 0;
  bool success = false;           ///< the best hypothesis comes within 1 m and stays there to the end
  double right_after_m = -1;      ///< until it was so
  double localized_after_m = -1;  ///< until the first `localized`
  double error_m = -1;            ///< of the best hypothesis, mean from there on
  int hypotheses_before = 0, hypotheses_after = 0;  ///< most, before and after the first `localized`
  int updates = 0, localized_rows = 0, false_rows = 0;  ///< `localized` and more than 1 m off
  double cpu_ms = 0;              ///< per update
  std::vector<opal::Point> truth; ///< of the robot, thinned; for pictures
};

ExperimentRun run_challenge(const Contender& contender, const opal::PluginRegistry& registry,
                            std::shared_ptr<const opal::SemanticMap> map, const opal::simulation::ChallengeDrive& driven);
