#pragma once

#include <CLI/CLI.hpp>

/// `opal map generate`.
void add_map_generate(CLI::App& map, int& exit_code);
