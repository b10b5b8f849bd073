#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map generate`.
void add_map_generate(CLI::App& map, int& exit_code);

}  // namespace opal::cli
