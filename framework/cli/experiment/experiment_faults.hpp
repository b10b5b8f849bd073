#pragma once

#include <CLI/CLI.hpp>

/// `opal experiment faults`.
void add_experiment_faults(CLI::App& experiment, int& exit_code);
