#pragma once

#include "benchmark/runs/recorded_log.hpp"
#include "cli/options/log_run_options.hpp"
#include "map_tools/test_maps/map_damage.hpp"

#include <opal/localization/localizer.hpp>
#include <opal/map/semantic_map.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace opal::cli {

/// What a verb that plays a recorded log was asked for, read and checked.
struct LogRunSetup {
  PluginRegistry plugins;
  Deployment deployment;  ///< with the lasers as the log states them
  std::shared_ptr<const SemanticMap> map;
  benchmark::RecordedLog log;
  std::vector<Query> windows;
  std::optional<GroundTruth> truth;
  LocalizerParts parts;
  std::vector<std::string> silent_lasers;  ///< frames that are described, and have no scan
  std::string mount_doubt;                 ///< in words; empty: the laser's place on the robot is stated

  /// Prints what is doubtful in the log, and in how it fits the description of the robot.
  void tell_doubts() const;
};

/// @param deployment  of these options, or one that was changed.
/// @param damage  done to the map first, if any.
/// @throws opal::Error naming the file of map, log, queries or truth that cannot be used.
LogRunSetup set_up(const LogRunOptions& options, Deployment deployment, const std::optional<MapDamage>& damage = {});

}  // namespace opal::cli
