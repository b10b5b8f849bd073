#pragma once

#include "derivation/feature_derivation.hpp"

#include <opal/plugin/plugin_registry.hpp>

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map derive`.
void add_map_derive(CLI::App& map, int& exit_code);

/// The map with the features that a detector finds on its objects. Says on standard output what was found.
/// @param detector  its type name.
/// @param words     its options, each "NAME=VALUE".
Derivation derived_by(const PluginRegistry& registry, const SemanticMap& map, const std::string& detector,
                      const std::vector<std::string>& words, const DerivationOptions& options);

}  // namespace opal::cli
