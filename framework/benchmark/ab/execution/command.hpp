#pragma once

#include <string>
#include <vector>

namespace opal::ab {

/// How another program ended.
struct CommandResult {
  int exit_code = 0;   ///< 127: there is no such program
  std::string output;  ///< stdout
  std::string errors;  ///< stderr
};

/// Runs a program, found in PATH, to its end. No shell takes part. @throws Error if no process can be started.
CommandResult run_command(const std::vector<std::string>& words);

/// The same where only success will do. @return stdout. @throws Error with the command, its exit code and what it
/// complained.
std::string output_of(const std::vector<std::string>& words);

}  // namespace opal::ab
