#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal experiment storeys`.
void add_experiment_storeys(CLI::App& experiment, int& exit_code);

}  // namespace opal::cli
