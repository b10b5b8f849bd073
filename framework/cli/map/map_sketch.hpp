#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map sketch`.
void add_map_sketch(CLI::App& map, int& exit_code);

}  // namespace opal::cli
