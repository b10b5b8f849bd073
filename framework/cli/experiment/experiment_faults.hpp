#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal experiment faults`.
void add_experiment_faults(CLI::App& experiment, int& exit_code);

}  // namespace opal::cli
