#pragma once

#include <CLI/CLI.hpp>

/// `opal experiment integrity`.
void add_experiment_integrity(CLI::App& experiment, int& exit_code);
