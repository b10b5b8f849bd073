#pragma once

#include <CLI/CLI.hpp>

/// `opal map redraw`.
void add_map_redraw(CLI::App& map, int& exit_code);
