#pragma once

namespace opal::cli {

/// What the program says by its exit code, the same for every command. docs/start.md lists them for users.
enum ExitCode : int {
  kDone = 0,
  kNo = 1,          ///< the answer is no: no pose, lost, not reached, a map with mistakes, nothing found
  kWrongUse = 2,    ///< a command, option or value that does not exist
  kBadInput = 3,    ///< a file that is missing or wrong, or does not fit the others
  kNotWritten = 4,  ///< a file or folder cannot be written
  kInUse = 5,       ///< another program writes into the folder
};

/// The run was ended by a signal, with what it had: 130 for SIGINT (Ctrl-C), 143 for SIGTERM, as shells have it.
constexpr int interrupted_by(int signal) {
  constexpr int kSignals = 128;
  return kSignals + signal;
}

}  // namespace opal::cli
