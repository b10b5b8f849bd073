#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal experiment integrity`.
void add_experiment_integrity(CLI::App& experiment, int& exit_code);

}  // namespace opal::cli
