#pragma once

#include <CLI/CLI.hpp>

namespace opal {

/// Each verb adds its subcommand with its options to the program, and sets the exit code when it has run.

/// `opal plugins [FOLDER or FILE...]`: what plugins offer. Exit code 1 if one was refused or breaks its
/// contract.
void add_plugins_verb(CLI::App& app, int& exit_code);

}  // namespace opal
