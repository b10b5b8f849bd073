#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map import SOURCE -o MAP`: a semantic map of whatever an importer recognizes.
void add_map_import(CLI::App& map, int& exit_code);

/// `opal map storeys FILE`: the levels of a building, and what an import of each would give. Exit code 1 if there are
/// none.
void add_map_storeys(CLI::App& map, int& exit_code);

}  // namespace opal::cli
