#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map frame MAP --frame FRAME`: the nodes of a map that match a frame. Exit code 1 if none does.
void add_map_frame(CLI::App& map, int& exit_code);

}  // namespace opal::cli
