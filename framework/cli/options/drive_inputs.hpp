#pragma once

#include "cli/options/log_run_options.hpp"
#include "learning/drive_evidence.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <memory>
#include <string>
#include <vector>

/// What drives say of a map: recorded logs, and evidence that was gathered before.
struct DriveInputs {
  LogRunOptions run;               ///< MAP, and how logs are played
  std::vector<std::string> files;  ///< logs, and evidence (.json)

  /// Adds MAP, LOG, --config, --info, --queries and --overlay.
  void add_to(CLI::App& verb);
  /// The evidence of all files; what is learned from logs is told on the screen.
  /// @throws opal::ConfigError naming a drive if it tells of another map.
  std::vector<opal::DriveEvidence> drives(const opal::PluginRegistry& registry,
                                          const std::shared_ptr<const opal::SemanticMap>& map) const;
};
