#pragma once

#include <CLI/CLI.hpp>

/// `opal experiment storeys`.
void add_experiment_storeys(CLI::App& experiment, int& exit_code);
