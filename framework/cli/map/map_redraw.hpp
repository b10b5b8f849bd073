#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map redraw`.
void add_map_redraw(CLI::App& map, int& exit_code);

}  // namespace opal::cli
