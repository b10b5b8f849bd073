#pragma once

#include <opal/map/semantic_map.hpp>
#include <opal/plugin/plugin_registry.hpp>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace opal::cli {

/// `opal map patterns`.
void add_map_patterns(CLI::App& map, int& exit_code);

/// Says how unique the patterns of a map's layer are, if it has one. @throws opal::MapError if the layer contradicts
/// its templates.
void check_layer(const PluginRegistry& registry, const std::shared_ptr<const SemanticMap>& map,
                 const std::string& sensor);

}  // namespace opal::cli
