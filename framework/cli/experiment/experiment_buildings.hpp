#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal experiment buildings -o OUT`: the challenges of Hendrikx (2023), 3.5.2, in many synthetic buildings.
void add_experiment_buildings(CLI::App& experiment, int& exit_code);

}  // namespace opal::cli
