#pragma once

#include <opal/plugin/plugin_registry.hpp>

#include <string>
#include <vector>

namespace opal::cli {

/// What all experiments have in common.
struct ExperimentOptions {
  std::string name, out, map;        ///< no map: the building like the thesis'
  std::vector<std::string> configs;  ///< who takes part
  std::vector<std::string> only;     ///< ids of runs; empty: all
  int seeds = 20, jobs = 2;
  double duration_s = 60, most_s = 900;
  std::string behaviour, trees;  ///< of the closed loop
  std::vector<std::string> baselines;
  bool logs = false;
};

/// The 14 challenges of Hendrikx (2023), section 3.5.2.
int experiment_thesis3(const ExperimentOptions& options, const PluginRegistry& registry);
/// The 12 runs of its table 4.1.
int experiment_thesis4(const ExperimentOptions& options, const PluginRegistry& registry);

}  // namespace opal::cli
