#pragma once

#include <CLI/CLI.hpp>

/// `opal map sketch`.
void add_map_sketch(CLI::App& map, int& exit_code);
