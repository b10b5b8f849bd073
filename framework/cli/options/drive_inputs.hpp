#pragma once

#include "cli/options/log_run_options.hpp"
#include "learning/drive_evidence.hpp"
#include "session/stored_maps.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <string>
#include <vector>

namespace opal::cli {

/// What drives say of a map: recorded logs, and evidence that was gathered before.
struct DriveInputs {
  LogRunOptions run;               ///< MAP, and how logs are played
  std::vector<std::string> files;  ///< logs, and evidence (.json); none: the fleet's, from the map store

  /// Adds MAP, LOG, --config, --info, --log-set, --queries and --overlay.
  void add_to(CLI::App& verb);
  /// The evidence of all files; without files, what robots have pushed about this version of the map. What is learned
  /// from logs, and what the store has that is no evidence, is told on the screen.
  /// @throws opal::ConfigError naming a drive if it tells of another map; without files if the map is in no store.
  std::vector<DriveEvidence> drives(const PluginRegistry& registry, const session::VersionedMap& map) const;
};

}  // namespace opal::cli
