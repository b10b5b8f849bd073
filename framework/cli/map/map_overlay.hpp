#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map overlay MAP OVERLAY... -o OUT`: the map with what overlays change and add. Exit code 1 if something in
/// them does not fit the map (any more).
void add_map_overlay(CLI::App& map, int& exit_code);

}  // namespace opal::cli
