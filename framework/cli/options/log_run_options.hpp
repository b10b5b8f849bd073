#pragma once

#include "cli/options/overlay_options.hpp"

#include <opal/deployment/deployment.hpp>
#include "evaluation/site.hpp"

#include <opal/sensing/log_source.hpp>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace opal::cli {

/// Adds --log-set.
void add_log_words(CLI::App& verb, std::vector<std::string>& words);

/// The options of every verb that plays a recorded log.
struct LogRunOptions {
  std::string config, log, out = "out", map, info, queries, truth;
  std::vector<std::string> log_words;  ///< options of the log's source
  OverlayFiles overlays;

  /// Adds what all these verbs say alike: CONFIG, LOG, --out, --map, --overlay, --log-set and --info.
  /// @param written  what goes into the folder.
  void add_to(CLI::App& verb, const std::string& written);
  /// The deployment with what was said instead or besides. @throws opal::ConfigError if it has no map.
  Deployment deployment() const;
  /// `described` with what the log states of its laser. @throws opal::ConfigError if it states something else.
  std::vector<LaserModel> lasers_of(const std::vector<LogRecord>& records,
                                    const std::vector<LaserModel>& described) const;
  /// In words, that neither the deployment nor the log says where the laser sits on the robot; empty: one of them does.
  std::string mount_doubt(const std::vector<LogRecord>& records, const Deployment& described) const;
  /// What to play: the queries, or the whole log.
  std::vector<Query> windows() const;
};

}  // namespace opal::cli
