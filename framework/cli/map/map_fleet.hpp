#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map push|pull|list`: the maps of a fleet's buildings, in versions, in a map store. Push has exit code 1 if the
/// building is not at the version that was expected.
void add_map_fleet(CLI::App& map, int& exit_code);

/// `opal map diff A B`: what differs between two maps. Exit code 1 if anything does.
void add_map_diff(CLI::App& map, int& exit_code);

}  // namespace opal::cli
