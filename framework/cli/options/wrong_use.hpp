#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace opal::cli {

/// What is said of words that no command takes: the command, what is wrong, the option that may be meant, and how the
/// command is used.
std::string wrong_use(const CLI::App& app, const CLI::Error& error);

}  // namespace opal::cli
