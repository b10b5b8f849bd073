#pragma once

#include <CLI/CLI.hpp>

namespace opal::cli {

/// No command writes over a file that it reads: it might be the only copy of a recording. A deployment may be written
/// anew in its place by the commands that complete deployments.
/// @param app  parsed.
/// @throws opal::ConfigError naming the file, the option that writes it and the one that reads it.
void expect_no_input_overwritten(const CLI::App& app);

}  // namespace opal::cli
