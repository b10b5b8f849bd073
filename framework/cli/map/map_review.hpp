#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// `opal map review MAP EVIDENCE... -o OVERLAY`: a person looks at what drives propose, and accepts or refuses it.
void add_map_review(CLI::App& map, int& exit_code);

}  // namespace opal::cli
